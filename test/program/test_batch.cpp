// SPDX-FileCopyrightText: 2026 The CSCD developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Tests of `cscd batch`: what becomes of good and bad inputs, and what is left when it is stopped.

#include "IO/mesh_files.h"
#include "program/Cscd.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <sstream>
#include <string>
#include <vector>

namespace {

using namespace test_support;

/// An option by which a torus takes many seconds.
const std::string slowly = " -- --method published --separators 100000";

class Batch : public Cscd
{
protected:
  void write_torus(const std::string& name, std::size_t around = 30, std::size_t across = 12)
  {
    std::filesystem::create_directories(std::filesystem::path(m_folder.file(name)).parent_path());
    m_folder.write(name, off(torus(around, across)));
  }

  /// Runs the program by a command of the shell, in which P stands for it. \return the exit status of the shell
  int run_by(std::string command)
  {
    command.replace(command.find('P'), 1, "'" CSCD_PROGRAM "'");
    const std::string line = "cd '" + m_folder.path().string() + "' && " + command + " > /dev/null 2>&1";
    const int status = std::system(line.c_str());
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  }

  /// The rows of a manifest by the names of their inputs; no field has a comma here.
  std::map<std::string, std::vector<std::string>> rows(const std::string& manifest) const
  {
    const std::string text = content(manifest);
    EXPECT_EQ(0u, text.rfind("input,status,number_of_sites,number_of_nodes,", 0)) << text;
    EXPECT_EQ('\n', text.empty() ? ' ' : text.back());
    std::map<std::string, std::vector<std::string>> result;
    std::istringstream in(text);
    std::string line;
    std::getline(in, line);
    while (std::getline(in, line)) {
      std::vector<std::string> fields(1);
      for (const char c : line) {
        if (c == ',') {
          fields.emplace_back();
        } else {
          fields.back() += c;
        }
      }
      EXPECT_EQ(12u, fields.size()) << line;
      EXPECT_TRUE(result.emplace(fields.front(), fields).second) << "twice: " << line;
    }
    return result;
  }

  std::vector<std::string> files_in(const std::string& folder) const
  {
    std::vector<std::string> result;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(m_folder.file(folder))) {
      if (!entry.is_directory()) {
        result.push_back(entry.path().lexically_relative(m_folder.file(folder)).string());
      }
    }
    std::sort(result.begin(), result.end());
    return result;
  }
};

TEST_F(Batch, bad_inputs_do_not_stop_the_others)
{
  write_torus("a.off");
  m_folder.write("b.off", "");
  write_torus("d.off", 36, 14);
  const Outcome outcome = run("batch a.off b.off c.off d.off --output-dir out --jobs 2");
  EXPECT_EQ(2, outcome.status);
  EXPECT_EQ("4 inputs, 2 done, 2 failed\n", outcome.out);
  EXPECT_EQ("", outcome.err);
  EXPECT_EQ((std::vector<std::string>{"a.graph", "d.graph", "manifest.csv"}), files_in("out"));
  const auto manifest = rows("out/manifest.csv");
  ASSERT_EQ(4u, manifest.size());
  EXPECT_EQ("done", manifest.at("a.off")[1]);
  EXPECT_EQ("360", manifest.at("a.off")[2]);
  EXPECT_EQ(manifest.at("a.off")[3], manifest.at("a.off")[4]) << "nodes and edges of a cycle";
  EXPECT_EQ("1", manifest.at("a.off")[6]) << "its Betti number";
  EXPECT_LT(0, std::stod(manifest.at("a.off")[9]));
  EXPECT_LT(1, std::stod(manifest.at("a.off")[10])) << "megabytes";
  EXPECT_EQ("failed", manifest.at("b.off")[1]);
  EXPECT_EQ(0u, manifest.at("b.off")[11].rfind("b.off: ", 0)) << manifest.at("b.off")[11];
  EXPECT_NE(std::string::npos, manifest.at("c.off")[11].find("cannot be opened"));

  run("skeletonize a.off -o alone.graph");
  EXPECT_EQ(content("alone.graph"), content("out/a.graph"));
}

TEST_F(Batch, results_lie_as_the_inputs_do)
{
  write_torus("meshes/cat/1.off");
  write_torus("meshes/dog/1.off");
  m_folder.write("list", "meshes/cat/1.off\r\n\nmeshes/dog/1.off\nmeshes/cat/../cat/1.off\n");
  EXPECT_EQ(0, run("batch --list list --output-dir out -- -o {}.json -o {}.swc --detail 0.3").status);
  EXPECT_EQ((std::vector<std::string>{"cat/1.json", "cat/1.swc", "dog/1.json", "dog/1.swc", "manifest.csv"}),
            files_in("out"));
  EXPECT_EQ(2u, rows("out/manifest.csv").size());
  EXPECT_EQ(0, run("batch --list - --output-dir again --quiet < list").status);
  EXPECT_EQ((std::vector<std::string>{"cat/1.graph", "dog/1.graph", "manifest.csv"}), files_in("again"));
}

TEST_F(Batch, what_takes_too_long_is_stopped)
{
  write_torus("slow.off", 200, 80);
  const Outcome outcome = run("batch slow.off --output-dir out --timeout 0.3" + slowly);
  EXPECT_EQ(2, outcome.status);
  EXPECT_EQ("timeout", rows("out/manifest.csv").at("slow.off")[1]);
  EXPECT_EQ(std::vector<std::string>{"manifest.csv"}, files_in("out"));
}

TEST_F(Batch, what_needs_too_much_memory_is_stopped)
{
  write_torus("large.off", 600, 200);
  write_torus("small.off");
  EXPECT_EQ(2, run("batch large.off small.off --output-dir out --memory 40").status);
  const auto manifest = rows("out/manifest.csv");
  EXPECT_EQ("memory", manifest.at("large.off")[1]) << manifest.at("large.off")[11];
  EXPECT_EQ("done", manifest.at("small.off")[1]) << manifest.at("small.off")[11];
  EXPECT_EQ(0, run("batch large.off small.off --output-dir more --memory 2G").status);
  expect_refusal("batch small.off --output-dir none --memory 2X", 1, {"--memory", "2X", "2G"});
}

TEST_F(Batch, goes_on_where_a_manifest_ends)
{
  std::string names;
  for (const std::string name : {"1.off", "2.off", "3.off", "4.off"}) {
    write_torus(name);
    names += name + " ";
  }
  m_folder.write("5.off", "");
  ASSERT_EQ(2, run("batch 1.off 2.off 5.off --output-dir out").status);
  expect_refusal("batch " + names + "--output-dir out", 1, {"out/manifest.csv", "--resume"});

  const std::string whole = content("out/manifest.csv");
  const auto before = rows("out/manifest.csv");
  m_folder.write("out/manifest.csv", whole + "3.off,timeout,,,,,,,,1.5,20,too slow\n4.off,do");
  std::filesystem::remove(m_folder.file("out/1.graph"));
  const Outcome outcome = run("batch " + names + "5.off --output-dir out --resume");
  EXPECT_EQ(0, outcome.status) << "of those of this run none failed";
  EXPECT_EQ("5 inputs, 3 in the manifest already, 2 done\n", outcome.out);
  const auto after = rows("out/manifest.csv");
  EXPECT_EQ(5u, after.size());
  for (const auto& [name, row] : before) {
    EXPECT_EQ(row, after.at(name));
  }
  EXPECT_EQ("done", after.at("3.off")[1]);
  EXPECT_EQ("done", after.at("4.off")[1]);
  EXPECT_EQ((std::vector<std::string>{"2.graph", "3.graph", "4.graph", "manifest.csv"}), files_in("out"));

  m_folder.write("out/manifest.csv", "x,y\n1,2\n");
  expect_refusal("batch 1.off --output-dir out --resume", 1, {"is no manifest"});
  EXPECT_EQ("x,y\n1,2\n", content("out/manifest.csv"));
}

TEST_F(Batch, leaves_nothing_half_done_when_it_is_interrupted)
{
  write_torus("quick.off");
  write_torus("slow.off", 200, 80);
  for (const std::string signal : {"INT", "TERM", "KILL"}) {
    const std::string folder = "out_" + signal;
    // the shell would let a process in the background ignore interrupts
    EXPECT_NE(0, run_by("timeout --signal=" + signal + " 1.5 P batch slow.off quick.off --jobs 1 --output-dir " +
                        folder + " -- --method published --separators 100000 -o {}.graph"));
    if (signal != "KILL") {
      EXPECT_EQ(std::vector<std::string>{"manifest.csv"}, files_in(folder)) << signal;
      EXPECT_FALSE(std::filesystem::exists(m_folder.file(folder + "/.cscd_batch")));
    }
    EXPECT_EQ(0u, rows(folder + "/manifest.csv").size()) << signal;
    EXPECT_EQ(0, run("batch quick.off slow.off --resume --output-dir " + folder).status) << "no process has it open";
    EXPECT_EQ((std::vector<std::string>{"manifest.csv", "quick.graph", "slow.graph"}), files_in(folder)) << signal;
  }
}

TEST_F(Batch, parts_together_are_the_whole)
{
  std::string names;
  for (std::size_t i = 0; i < 7; ++i) {
    const std::string name = std::to_string(i) + ".off";
    write_torus(name, 20 + 2 * i, 10);
    names += name + " ";
  }
  ASSERT_EQ(0, run("batch " + names + "--output-dir whole").status);
  for (const std::string part : {"1/3", "2/3", "3/3"}) {
    EXPECT_EQ(0, run("batch " + names + "--output-dir parts --part " + part).status);
  }
  EXPECT_EQ(3u, rows("parts/manifest_1_of_3.csv").size());
  EXPECT_EQ(2u, rows("parts/manifest_2_of_3.csv").size());
  EXPECT_EQ(2u, rows("parts/manifest_3_of_3.csv").size());
  for (std::size_t i = 0; i < 7; ++i) {
    const std::string name = std::to_string(i) + ".graph";
    EXPECT_NE("", content("whole/" + name));
    EXPECT_EQ(content("whole/" + name), content("parts/" + name));
  }
}

TEST_F(Batch, names_with_commas_and_quotes_are_read_back)
{
  write_torus("a, \"b\".off");
  ASSERT_EQ(0, run("batch 'a, \"b\".off' --output-dir out").status);
  EXPECT_NE(std::string::npos, content("out/manifest.csv").find("\n\"a, \"\"b\"\".off\",done,"));
  EXPECT_EQ("1 input, 1 in the manifest already\n", run("batch 'a, \"b\".off' --output-dir out --resume").out);
}

TEST_F(Batch, refuses_what_it_cannot_do)
{
  write_torus("a.off");
  m_folder.write("a.obj", "");
  expect_refusal("batch --output-dir out", 1, {"no inputs", "--list"});
  expect_refusal("batch a.off a.obj --output-dir out", 1, {"a.off and a.obj", "ending"});
  expect_refusal("batch a.off --output-dir out --part 3/2", 1, {"--part", "3/2"});
  expect_refusal("batch a.off --output-dir out --part x/2", 1, {"--part", "x/2"});
  expect_refusal("batch a.off --output-dir out -- -o one.graph", 1, {"{}"});
  expect_refusal("batch a.off --output-dir out -- -o {}.graph --branches=all.csv", 1, {"--branches", "{}"});
  expect_refusal("batch a.off --output-dir out -- --report r.json", 1, {"--report"});
  expect_refusal("batch a.off --output-dir out --timeout 0", 1, {"--timeout"});
  expect_refusal("batch --list nothing --output-dir out", 2, {"nothing: cannot be opened"});
  expect_refusal("batch a.off --output-dir a.obj", 2, {"a.obj"});
  EXPECT_FALSE(std::filesystem::exists(m_folder.file("out/manifest.csv")));
}

} // namespace
