package org.u2sa.trials.campaign;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.SortedMap;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class InputFilesTest {
  @TempDir private Path directory;

  @BeforeEach
  void files() throws IOException {
    write("home/config/ugv/Control.xml", "<configuration/>");
    write("home/missions/ugv.xml", "<mission/>");
    write("home/README.md", "");
    write("rover/system.xml", "<service class='A' configuration='Control.xml'/>");
    write("rover/Control.xml", "<configuration><variable name=\"M\" value=\"../data/h.asc\"/>");
    write("rover/beside.xml", "<file>deeper/engine.xml</file><w><uri>model://buoy</uri></w>");
    write("rover/deeper/engine.xml", "");
    write("rover/models/buoy/mesh.dae", "");
    write("data/h.asc", "ncols 2");
    write("worlds/pond.xml", "<world/>");
    write("other.xml", "");
    write("out/mission.xml", "");
  }

  private Map<String, String> environment = Map.of();
  private List<String> more = List.of();

  private void write(String name, String text) throws IOException {
    Path file = directory.resolve(name);
    Files.createDirectories(file.getParent());
    Files.writeString(file, text);
  }

  private SortedMap<String, String> inputs() {
    List<String> words = new ArrayList<>(more);
    words.addAll(
        List.of(
            "simulate",
            directory.resolve("rover/system.xml").toString(),
            "--set",
            "WorldModeler:WORLD=" + directory.resolve("worlds/pond.xml"),
            "--seed",
            "12",
            "--x=" + directory.resolve("out/mission.xml"),
            "/",
            "\u0000"));
    return InputFiles.of(words, directory.resolve("home"), directory.resolve("out"), environment);
  }

  @Test
  void of_command_isFilesNamedBesideAndReferencedButNotOthers() {
    assertThat(inputs().keySet())
        .allSatisfy(name -> assertThat(Path.of(name)).isRegularFile())
        .extracting(name -> directory.relativize(Path.of(name)).toString().replace('\\', '/'))
        .containsExactlyInAnyOrder(
            "home/config/ugv/Control.xml",
            "home/missions/ugv.xml",
            "rover/system.xml",
            "rover/Control.xml",
            "rover/beside.xml",
            "rover/deeper/engine.xml",
            "rover/models/buoy/mesh.dae",
            "data/h.asc",
            "worlds/pond.xml");
  }

  @Test
  void of_worldWithModelsOfGazebosVariables_countsTheirFiles() throws IOException {
    write("worlds/pond.xml", "<uri>model://dock</uri><uri>https://fuel/models/Oak</uri>");
    write("gazebo/dock/mesh.dae", "1");
    write("gazebo/Oak/model.sdf", "1");
    write("gazebo/other/model.sdf", "1");
    environment = Map.of("GZ_SIM_RESOURCE_PATH", directory.resolve("gazebo").toString());
    assertThat(inputs().keySet())
        .contains(
            directory.resolve("gazebo/dock/mesh.dae").toString(),
            directory.resolve("gazebo/Oak/model.sdf").toString())
        .doesNotContain(directory.resolve("gazebo/other/model.sdf").toString());
  }

  @Test
  void of_mapThatRunsWrite_isNoInputButOneThatTheyReadIs() throws IOException {
    write("rover/saved.map", "1");
    write("rover/read.map", "1");
    write(
        "rover/beside.xml",
        "<variable name=\"SAVE MAP\" value=\"saved.map\"/><variable name=\"MAP\" value=\"read.map\"/>");
    write("swept.map", "1");
    more = List.of("--set", "WorldModeler:SAVE MAP=" + directory.resolve("swept.map"));
    assertThat(inputs().keySet())
        .contains(directory.resolve("rover/read.map").toString())
        .doesNotContain(directory.resolve("rover/saved.map").toString())
        .doesNotContain(directory.resolve("swept.map").toString());
  }

  @ParameterizedTest
  @ValueSource(strings = {"rover/Control.xml", "data/h.asc", "home/missions/ugv.xml"})
  void difference_fileEdited_isThatFile(String name) throws IOException {
    SortedMap<String, String> before = inputs();
    assertThat(InputFiles.difference(before, inputs())).isEmpty();
    write(name, Files.readString(directory.resolve(name)) + " ");

    assertThat(InputFiles.difference(before, inputs()))
        .contains(directory.resolve(name).toString());
  }

  @Test
  void ofProgram_classEdited_differs() throws IOException {
    write("classes/org/A.class", "1");
    String classPath = directory.resolve("classes").toString();
    SortedMap<String, String> before = InputFiles.ofProgram(classPath);
    assertThat(InputFiles.difference(before, InputFiles.ofProgram(classPath))).isEmpty();
    write("classes/org/A.class", "2");

    assertThat(InputFiles.difference(before, InputFiles.ofProgram(classPath)))
        .contains("class path entry 1, classes");
  }
}
