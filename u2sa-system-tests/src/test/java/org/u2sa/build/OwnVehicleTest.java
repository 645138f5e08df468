package org.u2sa.build;

import static org.assertj.core.api.Assertions.assertThat;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.File;
import java.io.IOException;
import java.net.URISyntaxException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;
import javax.tools.ToolProvider;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.u2sa.cli.Main;
import org.u2sa.testkit.Repository;

/**
 * From an empty folder to a mission with an own class of goals and an object to find, as section 7
 * of docs/tutorial/vehicle.md describes it, for each kind of vehicle.
 */
@Tag("long")
class OwnVehicleTest {
  private static final String HEXACOPTER =
      "u2sa-scenarios/src/test/resources/org/u2sa/scenarios/simulate/copter";
  private static final String SERVICES =
      """
        <service class="org.u2sa.device.detection.ObjectDetectorSensor"/>
        <service class="org.u2sa.world.WorldModeler"/>
      """;

  @TempDir private Path home;

  private Path project() {
    return home.resolve("mine");
  }

  private Path config() {
    return project().resolve("config/mine");
  }

  /** Runs the command line in a folder, with the project's classes. */
  private void u2sa(Path folder, String... words) throws IOException, InterruptedException {
    List<String> command = new ArrayList<>();
    command.add(Path.of(System.getProperty("java.home"), "bin", "java").toString());
    command.addAll(List.of("-XX:+UseSerialGC", "-XX:TieredStopAtLevel=1", "-cp"));
    command.add(
        String.join(
            File.pathSeparator,
            project().resolve("classes").toString(),
            project().resolve("src/main/resources").toString(),
            System.getProperty("java.class.path")));
    command.add(Main.class.getName());
    command.addAll(List.of(words));
    Path output = home.resolve("output.txt");
    Process process =
        new ProcessBuilder(command)
            .directory(folder.toFile())
            .redirectErrorStream(true)
            .redirectOutput(output.toFile())
            .start();
    assertThat(process.waitFor()).as(Files.readString(output)).isZero();
  }

  private void compile() throws IOException {
    List<String> arguments =
        new ArrayList<>(List.of("-proc:none", "-cp", System.getProperty("java.class.path"), "-d"));
    arguments.add(Files.createDirectories(project().resolve("classes")).toString());
    try (Stream<Path> sources = Files.walk(project().resolve("src/main/java"))) {
      sources.map(Path::toString).filter(each -> each.endsWith(".java")).forEach(arguments::add);
    }
    assertThat(
            ToolProvider.getSystemJavaCompiler()
                .run(null, null, null, arguments.toArray(new String[0])))
        .as("javac")
        .isZero();
  }

  private void overlay(Path folder) throws IOException {
    try (Stream<Path> files = Files.list(folder)) {
      for (Path each : files.toList()) {
        Path to = config().resolve(each.getFileName().toString());
        Files.copy(each, to, StandardCopyOption.REPLACE_EXISTING);
      }
    }
  }

  private void insert(String file, String what, String before) throws IOException {
    Path path = config().resolve(file);
    String text = Files.readString(path);
    int at = text.indexOf(before);
    assertThat(at).as(before).isPositive();
    Files.writeString(path, text.substring(0, at) + what + text.substring(at));
  }

  @ParameterizedTest
  @CsvSource({
    "rover, <position>0.4 0 -0.4</position>",
    "boat, ''",
    "copter, ''",
    "plane, <reach>300</reach>"
  })
  void simulate_madeFromTemplates_completesOwnAndObjectGoalsWithoutContact(
      String kind, String detector) throws IOException, InterruptedException, URISyntaxException {
    u2sa(home, "new", "vehicle", "mine", "--kind", kind);
    u2sa(project(), "new", "mission-goal", "sample-spot");
    compile();
    if (kind.equals("copter")) {
      overlay(Repository.root().resolve(HEXACOPTER));
    }
    overlay(Path.of(OwnVehicleTest.class.getResource(kind).toURI()));
    insert(
        "vehicle.xml",
        "<detector preset=\"stereo camera\">" + detector + "</detector>",
        "</vehicle>");
    insert("system.xml", SERVICES, "  <service class=\"org.u2sa.mission.");

    for (String seed : List.of("1200021", "1200022", "1200023")) {
      u2sa(
          project(),
          "simulate",
          "config/mine/system.xml",
          "--vehicle",
          "config/mine/vehicle.xml",
          "--mission",
          "config/mine/spots.xml",
          "--world",
          "config/mine/yard.xml",
          "--seed",
          seed,
          "--port",
          "0",
          "--out",
          seed);
      JsonNode summary =
          new ObjectMapper().readTree(project().resolve(seed + "/summary.json").toFile());
      assertThat(summary.get("goalsCompleted").asInt()).as(seed).isEqualTo(4);
      assertThat(summary.get("waypointsCaptured").asInt()).as(seed).isEqualTo(3);
      assertThat(summary.get("contacts").asInt()).as(seed).isZero();
    }
  }
}
