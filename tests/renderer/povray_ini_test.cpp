// SPDX-License-Identifier: Apache-2.0
// POV-Ray's .ini files: what they set, and what is refused.
#include "renderer/errors.h"
#include "renderer/povray_ini.h"

#include <doctest/doctest.h>

using namespace proxima;

namespace {

std::string refusal(const std::string& text) {
    try {
        parse_povray_ini("Input_File_Name=a.pov\n" + text, "", "a.ini");
        return "";
    } catch (const UsageError& error) {
        return error.what();
    }
}

} // namespace

TEST_CASE("ini: a still's settings") {
    const IniOptions ini =
        parse_povray_ini("; a comment\n# another\nInput_File_Name = \"scenes/a.pov\"\r\nWidth=320 ; pixels\n"
                         "height=200\nClock=0.25\nOutput_File_Name=b.png\nBits_Per_Color=16\n"
                         "Declare=N=3\nDeclare=M=\"x\"\nLibrary_Path=lib\nWork_Threads=2\n"
                         "Antialias=off\nDisplay=On\nQuality=9\n",
                         "", "a.ini");
    CHECK(ini.scene == "scenes/a.pov");
    CHECK(ini.size == "320x200");
    CHECK(ini.clock == "0.25");
    CHECK(ini.frames == "");
    CHECK(ini.output == "b.png");
    CHECK(ini.bits == "16");
    CHECK(ini.threads == "2");
    CHECK(ini.declares == std::vector<std::string>{"N=3", "M=\"x\""});
    CHECK(ini.include_paths == std::vector<std::string>{"lib"});
}

TEST_CASE("ini: an animation's settings, and POV-Ray's names for its frames") {
    const std::string text = "Input_File_Name=a.pov\nInitial_Frame=1\nFinal_Frame=120\nSubset_Start_Frame=31\n";
    const IniOptions ini =
        parse_povray_ini(text + "Initial_Clock=-1\nFinal_Clock=2\nCyclic_Animation=on\n", "", "a.ini");
    CHECK(ini.frames == "1-120");
    CHECK(ini.subset == "31-120");
    CHECK(ini.clock == "-1:2");
    CHECK(ini.cyclic);
    CHECK(ini.output == "a%03d.png");
    CHECK(parse_povray_ini(text + "Output_File_Name=out/\nOutput_File_Type=E\n", "", "a.ini").output ==
          "out/a%03d.exr");
    CHECK(parse_povray_ini("Input_File_Name=a.pov\nFinal_Frame=9\nCyclic_Animation=1", "", "a.ini").output ==
          "a%02d.png");
    CHECK(parse_povray_ini("Input_File_Name=a.pov\nInitial_Frame=1\nFinal_Frame=1", "", "a.ini").frames == "");
}

TEST_CASE("ini: a section is read when it is asked for") {
    const std::string text = "Input_File_Name=a.pov\nWidth=8\nHeight=6\n[Large]\nWidth=80\nHeight=60\n[broken]\nfoo\n";
    CHECK(parse_povray_ini(text, "", "a.ini").size == "8x6");
    CHECK(parse_povray_ini(text, "large", "a.ini").size == "80x60");
    CHECK_THROWS_AS(parse_povray_ini(text, "small", "a.ini"), UsageError);
    CHECK(is_povray_ini("a.ini"));
    CHECK(is_povray_ini("a.INI[Large]"));
    CHECK(!is_povray_ini("a.scn"));
}

TEST_CASE("ini: antialiasing becomes the option of that name") {
    const auto option = [](const std::string& text) {
        const IniOptions ini = parse_povray_ini("Input_File_Name=a.pov\n" + text, "", "a.ini");
        return ini.antialias_refusal.empty() ? ini.antialias : ini.antialias_refusal;
    };
    CHECK(option("Antialias_Threshold=0.1\nJitter=on") == "");
    CHECK(option("Antialias=off\nSampling_Method=9") == "");
    CHECK(option("Antialias=On\nJitter=Off") == "method1:0.3:3");
    CHECK(option("Antialias=On\nJitter_Amount=0") == "method1:0.3:3");
    CHECK(option("Sampling_Method=2\nAntialias_Threshold=0.05\nAntialias=on\nAntialias_Depth=4\njitter=no") ==
          "method2:0.05:4");
    CHECK(option("Jitter=off\nAntialias=on\nAntialias_Gamma=2.5\nAntialias_Threshold=0.0") == "method1:0:3");
    CHECK(option("Antialias=on") ==
          "a.ini:2: Antialias=on: POV-Ray would jitter the rays, which Proxima does not; write Jitter=off, or choose "
          "--antialias or --samples yourself");
    CHECK(option("Jitter=off\nAntialias=on\nAntialias_Depth=12") ==
          "a.ini:3: Antialias_Depth=12: write a number from 1 to 9");
    CHECK(option("Jitter=off\nAntialias=on\nAntialias_Threshold=x") ==
          "a.ini:3: Antialias_Threshold=x: write a number from 0 to 1");
    CHECK(option("Jitter=off\nAntialias=on\nSampling_Method=3") ==
          "a.ini:3: Sampling_Method=3: write a number from 1 to 2");
    CHECK(option("Jitter=off\nAntialias=on\nAntialias_Gamma=2") ==
          "a.ini:3: Proxima does not support Antialias_Gamma=2; leave it out, it is 2.5");
    CHECK(refusal("Antialias=0.2") == "a.ini:2: Antialias=0.2: write on or off");
}

TEST_CASE("ini: what would change the picture is refused with its line") {
    CHECK(refusal("Quality=4") == "a.ini:2: Proxima does not support Quality=4");
    CHECK(refusal("\nFile_Gamma=2.2") == "a.ini:3: Proxima does not support File_Gamma=2.2");
    CHECK(refusal("Start_Row=10") == "a.ini:2: Proxima does not support Start_Row=10");
    CHECK(refusal("Post_Frame_Command=rm") == "a.ini:2: Proxima does not support Post_Frame_Command=rm");
    CHECK(refusal("Frame_Step=2") == "a.ini:2: Proxima does not support Frame_Step=2");
    CHECK(refusal("Output_File_Type=T") ==
          "a.ini:2: Output_File_Type=T: Proxima writes N (PNG), E (OpenEXR) and J (JPEG)");
    CHECK(refusal("+W640") == "a.ini:2: '+W640' is no setting; write Name=value");
    CHECK(refusal("Final_Frame=0.5") == "a.ini:2: Final_Frame=0.5: write a whole number");
    CHECK(refusal("Cyclic_Animation=maybe") == "a.ini:2: Cyclic_Animation=maybe: write on or off");
    CHECK(refusal("Width=640") == "a.ini: Width and Height need each other");
    CHECK_THROWS_AS(parse_povray_ini("Width=3", "", "a.ini"), UsageError);
}
