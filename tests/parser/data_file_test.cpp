// SPDX-License-Identifier: Apache-2.0
// #fopen, #read and #fclose. Values and refusals of POV-Ray 3.7.
#include "parser/data_file.h"
#include "parser/scene_script.h"
#include "tests/folder.h"

#include <doctest/doctest.h>
#include <sys/stat.h>

using namespace proxima;
using namespace proxima::testing;

namespace {

/// What #debug printed, or the first mistake.
std::string output_of(const Folder& folder, const std::string& scene) {
    Diagnostics diagnostics;
    SceneScript script(folder.write("scene.scn", scene), {}, diagnostics);
    std::string output;
    EvaluationSettings settings;
    settings.debug = [&](std::string_view text) { output += text; };
    script.evaluate(settings, diagnostics);
    for (const Diagnostic& diagnostic : diagnostics.all())
        if (diagnostic.severity == Severity::error)
            return diagnostic.message;
    return output;
}

/// Reads `data` to its end, a number P and a number Q at a time.
std::string pairs_in(const std::string& data) {
    const Folder folder;
    folder.write("data.txt", data);
    return output_of(folder,
                     "#declare P = -1; #declare Q = -1;\n#fopen F \"data.txt\" read\n"
                     "#while (defined(F)) #read (F, P, Q) #debug concat(\"[\", str(P, 0, 1), \" \", str(Q, 0, 1), "
                     "\"]\") #end");
}

} // namespace

TEST_CASE("data files: #read takes values until the file ends") {
    CHECK(pairs_in("1,2,3,4") == "[1.0 2.0][3.0 4.0]");
    CHECK(pairs_in("1, 2,\n3, 4 \n") == "[1.0 2.0][3.0 4.0]");
    CHECK(pairs_in("1,-2,+3,- 4e0") == "[1.0 -2.0][3.0 -4.0]");
    CHECK(pairs_in("1 /* one /* and */ more */, // two\n 2.5") == "[1.0 2.5]");
    CHECK(pairs_in("1,2,3") == "[1.0 2.0][3.0 2.0]");
}

TEST_CASE("data files: a comma behind the last value, or an empty file, is the end only when it is read") {
    CHECK(pairs_in("1,2,3,4,\n") == "[1.0 2.0][3.0 4.0][3.0 4.0]");
    CHECK(pairs_in("") == "[-1.0 -1.0]");
    CHECK(pairs_in("\n") == "[-1.0 -1.0]");
}

TEST_CASE("data files: what POV-Ray would drop or refuse is a mistake") {
    const std::string comma = "a comma must stand here";
    CHECK(pairs_in("1,2\n3,4") == comma);
    CHECK(pairs_in("1 2 3 4") == comma);
    CHECK(pairs_in("1,2*3") == comma);
    CHECK(pairs_in("1.5e,2") == comma);
    CHECK(pairs_in("1,,2") == "no value begins here");
    CHECK(pairs_in("1,pi") == "no value begins here");
    CHECK(pairs_in("1,--2") == "no value begins here");
    CHECK(pairs_in("1,1e999") == "this is no number, or too large or too small for a double");
    CHECK(pairs_in("<1>,2") == "no value begins here");
    CHECK(pairs_in("<1,2,3,4,5,6>,2") == "a vector has at most 5 terms");
    CHECK(pairs_in("1,/* 2") == "this comment is not closed");
    CHECK(pairs_in("1,\"a") == "this string is not closed");
    CHECK(pairs_in("1,\"a\\q\"") == "unknown escape sequence in a string");
}

TEST_CASE("data files: vectors and strings") {
    const Folder folder;
    folder.write("data.txt", "<1, -2>, <1 2 3>,<1,2,3,4,5,> ,\"a \\\"b\\\"\"");
    CHECK(output_of(folder, "#fopen F \"data.txt\" read #read (F, A, B, C, D)\n"
                            "#debug concat(vstr(2, A, \",\", 0, 0), \" \", vstr(3, B, \",\", 0, 0), \" \", "
                            "vstr(5, C, \",\", 0, 0), \" \", D)") == "1,-2 1,2,3 1,2,3,4,5 a \"b\"");
}

TEST_CASE("data files: a name that is read lives where #declare would have put it") {
    const Folder folder;
    folder.write("data.txt", "1,2,3,4");
    const std::string open = "#fopen F \"data.txt\" read\n";
    CHECK(output_of(folder, open + "#macro M() #read (F, A) #end M() #debug str(A, 0, 0)") == "1");
    CHECK(output_of(folder, open + "#macro M(P) #read (F, P) #end #declare Z = 9; M(Z) #debug str(Z, 0, 0)") == "1");
    CHECK(output_of(folder,
                    open + "#declare A = array[2] { 8, 9 } #read (F, A[1], A[0]) #debug str(A[0]*10 + A[1], 0, 0)") ==
          "21");
    CHECK(output_of(folder, "#macro Open() " + open + "#end Open() #read (F, A) #debug str(A, 0, 0)") == "1");
    CHECK(output_of(folder, open + "#declare A = <1, 2>; #read (F, A)") == "unexpected 'A', which is a vector");
    CHECK(output_of(folder, open + "#declare A = array[2]; #read (F, A[0])") ==
          "this element of the array has no value yet");
    CHECK(output_of(folder, open + "#read (F, A, B, C, D, E) #debug str(defined(F) + 10*defined(E), 0, 0)") == "0");
    CHECK(output_of(folder, open + "#read (F, 3)") == "unexpected '3'");
}

TEST_CASE("data files: handles are opened, closed and no values") {
    const Folder folder;
    folder.write("data.txt", "1,2,3,4");
    const std::string open = "#fopen F \"data.txt\" read\n";
    CHECK(output_of(folder, open + "#fclose F #debug str(defined(F), 0, 0)") == "0");
    CHECK(output_of(folder, open + "#read (F, A) #fclose F " + open + "#read (F, B) #debug str(A + B, 0, 0)") == "2");
    CHECK(output_of(folder, "#fclose F #debug \"fine\"") == "fine");
    CHECK(output_of(folder, open + open) == "'F' is an open file already");
    CHECK(output_of(folder, open + "#declare G = F;") == "unexpected 'F', which is an open file");
    CHECK(output_of(folder, open + "#macro M(P) #end M(F)") == "an open file cannot be passed to a macro");
    CHECK(output_of(folder, "#read (F, A)") == "'F' is not declared");
    CHECK(output_of(folder, "#fopen F \"none.txt\" read #read (F, A)") == "there is no file none.txt");
    CHECK(output_of(folder, "#fopen F \"data.txt\" write") == "a scene writes no files");
    CHECK(output_of(folder, "#fopen F \"data.txt\" append") == "a scene writes no files");
    CHECK(output_of(folder, "#write (F, 1)") == "Proxima does not support #write");
    CHECK(output_of(folder, "#debug str(file_exists(\"data.txt\") + 10*file_exists(\"none.txt\"), 0, 0)") == "1");
}

TEST_CASE("data files: nothing outside of the scene's folder, and nothing but files, is opened") {
    const Folder outside;
    const std::string secret = outside.write("secret.txt", "1,2").string();
    const Folder folder;
    std::filesystem::create_symlink(secret, folder.path / "link.txt");
    std::filesystem::create_symlink(outside.path, folder.path / "linked");
    std::filesystem::create_symlink("/dev/zero", folder.path / "zero.txt");
    std::filesystem::create_directory(folder.path / "folder.txt");
    mkfifo((folder.path / "pipe.txt").c_str(), 0600);
    const auto opening = [&](const std::string& name) {
        return output_of(folder, "#fopen F \"" + name + "\" read #read (F, A) #debug str(A, 0, 0)");
    };
    const auto refused = [](const std::string& message, const char* reason) {
        return message.find(reason) != std::string::npos;
    };
    const char* out = "outside of the scene's folder";
    CHECK(refused(opening(secret), "give a path relative to the scene's folder"));
    CHECK(refused(opening("/dev/zero"), "give a path relative to the scene's folder"));
    CHECK(refused(opening("../" + outside.path.filename().string() + "/secret.txt"), out));
    CHECK(refused(opening("link.txt"), out));
    CHECK(refused(opening("linked/secret.txt"), out));
    CHECK(refused(opening("zero.txt"), out));
    CHECK(refused(opening("folder.txt"), "it is a folder"));
    CHECK(refused(opening("pipe.txt"), "not a regular file"));
    CHECK(refused(output_of(folder, "#declare E = file_exists(\"link.txt\");"), out));
}
