// SPDX-License-Identifier: Apache-2.0
// rand.inc: random numbers of many distributions. Each macro takes as many numbers of its stream as POV-Ray's, in the
// same order, so that what comes after it is the same too.
#include "parser/standard/texts.h"

namespace proxima::standard {

std::string rand() {
    return R"(
#include "consts.inc"

#declare RdmA = seed(574647);
#declare RdmB = seed(324879);
#declare RdmC = seed(296735);
#declare RdmD = seed(978452);

#macro SRand(Stream) (rand(Stream)*2 - 1) #end
#macro RRand(Low, High, Stream) (rand(Stream)*(High - Low) + Low) #end
#macro Prob(P, Stream) (rand(Stream) < P) #end
#macro VRand(Stream) <rand(Stream), rand(Stream), rand(Stream)> #end
#macro VRand_In_Box(Low, High, Stream) (VRand(Stream)*(High - Low) + Low) #end
#macro VRand_On_Sphere(Stream)
  #local Around = 2*pi*rand(Stream);
  #local Down = acos(2*rand(Stream) - 1);
  (<cos(Around)*sin(Down), sin(Around)*sin(Down), cos(Down)>)
#end
#macro VRand_In_Sphere(Stream)
  #local Far = pow(rand(Stream), 1/3);
  (Far*VRand_On_Sphere(Stream))
#end

#macro Rand_Spline(Curve, Stream)
  #local Searching = 1;
  #while (Searching)
    #local Value = rand(Stream);
    #local Searching = (Curve(Value).y < rand(Stream));
  #end
  (Value)
#end

#macro Rand_Bernoulli(P, Stream) (P >= rand(Stream) ? 1 : 0) #end
#macro Rand_Cauchy(Center, Width, Stream) (Width*tan(pi*(rand(Stream) - 0.5)) + Center) #end
#macro Rand_Exp(Rate, Stream) (-ln(rand(Stream))/Rate) #end
#macro Rand_Geo(P, Stream) floor(ln(rand(Stream))/ln(1 - P)) #end
#macro Rand_Pareto(Shape, Stream) (1/pow(rand(Stream), 1/Shape)) #end
#macro Rand_Weibull(Width, Shape, Stream) (Width*pow(-ln(rand(Stream)), 1/Shape)) #end
#macro Rand_Triangle(Low, High, Peak, Stream)
  #local U = rand(Stream);
  (U <= (Peak - Low)/(High - Low) ? Low + sqrt((Peak - Low)*(High - Low)*U)
                                  : High - sqrt((High - Peak)*(High - Low)*(1 - U)))
#end
#macro Rand_Erlang(Average, K, Stream)
  #local Together = 1;
  #local Count = 0;
  #while (Count < K)
    #local Together = Together*rand(Stream);
    #local Count = Count + 1;
  #end
  (-Average*ln(Together))
#end
#macro Rand_Binomial(N, P, Stream)
  #local Hits = 0;
  #local N = int(N);
  #local Count = 0;
  #while (Count < N)
    #if (rand(Stream) <= P)
      #local Hits = Hits + 1;
    #end
    #local Count = Count + 1;
  #end
  (Hits)
#end
#macro Rand_Poisson(Average, Stream)
  #local Least = exp(-Average);
  #local Together = 1;
  #local Count = 0;
  #while (Together > Least)
    #local Together = Together*rand(Stream);
    #local Count = Count + 1;
    #if (Count > 100000)
      #local Together = Least;
    #end
  #end
  (Count)
#end

#macro Rand_Normal(Average, Width, Stream)
  #local Scale = 4*exp(-0.5)/sqrt(2);
  #local Again = yes;
  #while (Again)
    #local U = rand(Stream);
    #local N = Scale*(rand(Stream) - 0.5)/U;
    #local Again = (N*N/4 > -ln(U));
  #end
  (Average + (N*Width))
#end
// Normal numbers come in pairs: the second one waits for the next call.
#declare Gauss_Next = false;
#macro Rand_Gauss(Average, Width, Stream)
  #local N = Gauss_Next;
  #declare Gauss_Next = false;
  #if (!N)
    #local Around = rand(Stream)*2*pi;
    #local Far = sqrt(-2*ln(1 - rand(Stream)));
    #local N = cos(Around)*Far;
    #declare Gauss_Next = sin(Around)*Far;
  #end
  (Average + (N*Width))
#end
#macro Rand_Lognormal(Average, Width, Stream) exp(Rand_Gauss(Average, Width, Stream)) #end

// Shape 1/2 and below fail, as in POV-Ray: the root is taken before the case is known.
#macro Rand_Gamma(Shape, Width, Stream)
  #if (Shape <= 0 | Width <= 0)
    #error "the first two arguments of Rand_Gamma must be above 0"
  #end
  #local Root = sqrt(2*Shape - 1);
  #local Again = yes;
  #if (Shape > 1)
    #while (Again)
      #local U = rand(Stream);
      #local W = rand(Stream);
      #local Exponent = ln(U/(1 - U))/Root;
      #local N = Shape*exp(Exponent);
      #local Z = U*U*W;
      #local Bound = Shape - ln(4) + (Shape + Root)*Exponent - N;
      #local Again = !(Bound + (1 + ln(4.5)) - 4.5*Z >= 0 | Bound >= ln(Z));
    #end
  #end
  #if (Shape = 1)
    #local U = rand(Stream);
    #while (U <= 1e-7)
      #local U = rand(Stream);
    #end
    #local N = -ln(U);
  #end
  #if (Shape > 0 & Shape < 1)
    #while (Again)
      #local Share = (e + Shape)/e;
      #local U = Share*rand(Stream);
      #if (U <= 1)
        #local N = pow(U, 1/Shape);
      #else
        #local N = -ln((Share - U)/Shape);
      #end
      #local W = rand(Stream);
      #local Again = ((U <= 1 & W > exp(-N)) | (U > 1 & W > pow(N, Shape - 1)));
    #end
  #end
  #local Scaled = Width*N;
  Scaled
#end
#macro Rand_Chi_Square(N, Stream) (Rand_Gamma(2, 0.5*int(N), Stream)) #end
#macro Rand_Student(N, Stream) (Rand_Gauss(0, 1, Stream)/sqrt(Rand_Chi_Square(N, Stream)/N)) #end
#macro Rand_Beta(A, B, Stream)
  #if (A <= 0 | B <= 0)
    #error "the first two arguments of Rand_Beta must be above 0"
  #end
  #local First = Rand_Gamma(A, 1, Stream);
  #if (First = 0)
    #local Share = 0;
  #else
    #local Share = First/(First + Rand_Gamma(B, 1, Stream));
  #end
  (Share)
#end
#macro Rand_F_Dist(N, M, Stream)
  #local First = Rand_Chi_Square(M, Stream);
  #local Second = Rand_Chi_Square(N, Stream);
  ((M*First)/(N*Second))
#end
)";
}

} // namespace proxima::standard
