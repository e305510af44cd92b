// SPDX-License-Identifier: Apache-2.0
// arrays.inc: macros on arrays of one dimension. Sorting swaps and compares by the macros Sort_Swap_Data and
// Sort_Compare, which a scene may replace, in POV-Ray's order: quicksort (C. A. R. Hoare, "Quicksort", 1962) down to
// short stretches, then insertion.
#include "parser/standard/texts.h"

namespace proxima::standard {

std::string arrays() {
    return R"(
#macro Rand_Array_Item(List, Stream)
  #if (dimensions(List) != 1) #error "Rand_Array_Item takes an array of one dimension" #end
  List[floor(rand(Stream)*0.9999999*dimension_size(List, 1))]
#end
#macro Resize_Array(List, Size)
  #if (dimensions(List) != 1) #error "Resize_Array takes an array of one dimension" #end
  #local Resized = array[Size];
  #local Place = 0;
  #while (Place < min(Size, dimension_size(List, 1)))
    #ifdef (List[Place]) #local Resized[Place] = List[Place]; #end
    #local Place = Place + 1;
  #end
  #declare List = Resized;
#end
#macro Reverse_Array(List)
  #if (dimensions(List) != 1) #error "Reverse_Array takes an array of one dimension" #end
  #local Last = dimension_size(List, 1) - 1;
  #local Place = 0;
  #while (Place < Last/2)
    #local Item = List[Place];
    #local List[Place] = List[Last - Place];
    #local List[Last - Place] = Item;
    #local Place = Place + 1;
  #end
#end

#macro Sort_Compare(List, A, B) (List[A] < List[B]) #end
#macro Sort_Swap_Data(List, A, B)
  #local Item = List[A];
  #declare List[A] = List[B];
  #declare List[B] = Item;
#end
#declare ARRAYS_QuickSortSeed = seed(0);
#macro ARRAYS_HybridQuickSortStep(List, Begin, End)
  #local From = Begin;
  #while (From < End - 10)
    #local Pivot = From + rand(ARRAYS_QuickSortSeed)*(End - From);
    Sort_Swap_Data(List, From, Pivot)
    #local Left = From - 1;
    #local Right = End + 1;
    #local Border = -1;
    #while (Border < 0)
      #local Right = Right - 1;
      #while (Sort_Compare(List, From, Right)) #local Right = Right - 1; #end
      #local Left = Left + 1;
      #while (Sort_Compare(List, Left, From)) #local Left = Left + 1; #end
      #if (Left < Right)
        Sort_Swap_Data(List, Left, Right)
      #else
        #local Border = Right;
      #end
    #end
    ARRAYS_HybridQuickSortStep(List, From, Border)
    #local From = Border + 1;
  #end
#end
#macro ARRAYS_InsertionSort(List, Begin, End)
  #local Next = Begin + 1;
  #while (Next <= End)
    #local Place = Next;
    #while (Place > Begin)
      #local Before = Place - 1;
      #if (Sort_Compare(List, Place, Before))
        Sort_Swap_Data(List, Place, Before)
        #local Place = Before;
      #else
        #local Place = 0;
      #end
    #end
    #local Next = Next + 1;
  #end
#end
#macro Sort_Partial_Array(List, Begin, End)
  ARRAYS_HybridQuickSortStep(List, Begin, End)
  ARRAYS_InsertionSort(List, Begin, End)
#end
#macro Sort_Array(List) Sort_Partial_Array(List, 0, dimension_size(List, 1) - 1) #end
)";
}

std::string array_statistics() {
    return R"(
#macro Mean(List)
  #local Total = 0;
  #local Place = 0;
  #while (Place < dimension_size(List, 1))
    #local Total = Total + List[Place];
    #local Place = Place + 1;
  #end
  (Total/Place)
#end
#macro Std_Dev(List, Average)
  #local Total = 0;
  #local Place = 0;
  #while (Place < dimension_size(List, 1))
    #local Total = Total + pow(List[Place] - Average, 2);
    #local Place = Place + 1;
  #end
  sqrt(Total/Place)
#end
#macro GetStats(List)
  #local Total = 0;
  #local Squares = 0;
  #local Least = 10e15;
  #local Most = -10e15;
  #local Place = 0;
  #while (Place < dimension_size(List, 1))
    #local Item = List[Place];
    #local Total = Total + Item;
    #local Squares = Squares + (Item*Item);
    #local Least = min(Least, Item);
    #local Most = max(Most, Item);
    #local Place = Place + 1;
  #end
  #local Average = Total/Place;
  #declare StatisticsArray = array[5] {Place, Average, Least, Most, sqrt((Squares/Place) - Average*Average)}
#end
// POV-Ray's Histogram reads the length of the list from a name N, which the scene has to declare.
#macro Histogram(List, Intervals)
  GetStats(List)
  #local Least = StatisticsArray[2];
  #local Intervals = int(Intervals);
  #local Width = (StatisticsArray[3] - Least)/Intervals;
  #declare HistogramArray = array[Intervals][2];
  #local Bar = 0;
  #while (Bar < Intervals)
    #declare HistogramArray[Bar][0] = Least + Width*(Bar + 0.5);
    #declare HistogramArray[Bar][1] = 0;
    #local Bar = Bar + 1;
  #end
  #local Place = 0;
  #while (Place < N)
    #local Bar = int((List[Place] - Least)/Width);
    #local Bar = min(Bar, Intervals - 1);
    #declare HistogramArray[Bar][1] = HistogramArray[Bar][1] + 1;
    #local Place = Place + 1;
  #end
#end
)";
}

} // namespace proxima::standard
