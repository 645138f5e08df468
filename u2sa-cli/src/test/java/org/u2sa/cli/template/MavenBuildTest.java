package org.u2sa.cli.template;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.net.URISyntaxException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.u2sa.testkit.NeedsProgram;
import picocli.CommandLine;

/** The commands that {@code u2sa new} tells, with Maven itself, without a network. */
@Tag("long")
@NeedsProgram("mvn")
class MavenBuildTest {
  private static final Path ROOT = Path.of("").toAbsolutePath().getParent();

  private static final Pattern OTHER_MODULES =
      Pattern.compile(
          "<dependency>\\s*<groupId>org.u2sa</groupId>\\s*<artifactId>u2sa-(?!estimation|bom)"
              + "[^<]*</artifactId>.*?</dependency>",
          Pattern.DOTALL);

  private static final String ESTIMATION_TEST =
      """
      import static org.junit.jupiter.api.Assertions.assertEquals;

      import java.util.ArrayList;
      import java.util.List;
      import java.util.Map;
      import org.junit.jupiter.api.Test;
      import org.u2sa.estimation.PassThroughStateEstimator;
      import org.u2sa.interfaces.communication.Channels;
      import org.u2sa.interfaces.communication.LocalBus;
      import org.u2sa.interfaces.configuration.XmlConfiguration;
      import org.u2sa.interfaces.time.LockstepClock;
      import org.u2sa.messages.StateInformation;
      import org.u2sa.messages.frame.ReferenceFrame;
      import org.u2sa.service.ServiceContext;

      class EstimationTest {
        @Test
        void estimator_fix_becomesTheState() throws Exception {
          LockstepClock clock = new LockstepClock();
          LocalBus bus = new LocalBus("consumer");
          List<StateInformation> states = new ArrayList<>();
          bus.attach(
              (channel, message) -> {
                if (channel.equals(Channels.STATE)) {
                  states.add((StateInformation) message);
                }
              });
          PassThroughStateEstimator estimator =
              new PassThroughStateEstimator(
                  ServiceContext.of("consumer", XmlConfiguration.inMemory("test", Map.of()))
                      .clock(clock)
                      .transport(bus)
                      .build());
          estimator.start();
          clock.advance(0);
          StateInformation fix = new StateInformation().sensorName("gps");
          fix.referenceFrame(ReferenceFrame.LOCAL_NED).x(3.0).y(4.0).psi(0.5);
          fix.systemId("consumer");
          fix.timestamp(clock.micros());
          fix.freeze();
          bus.deliver(Channels.SENSED_STATE, fix);
          clock.advance(1_000_000);
          estimator.shutDown();
          assertEquals(3.0, states.get(0).x().orElseThrow());
        }
      }
      """;

  @TempDir Path folder;

  /**
   * A local repository that has what the user's has, but no U2SA; what is installed there stays
   * there.
   */
  private Path repository() throws IOException, URISyntaxException {
    Path jar =
        Path.of(CommandLine.class.getProtectionDomain().getCodeSource().getLocation().toURI());
    Path users = jar.resolve("../../../../..").normalize(); // group, name, version, jar
    assumeTrue(
        Files.isDirectory(users.resolve("org/apache/maven")),
        jar + " is not in a repository of Maven's: another build runs this test");
    Path ours = Files.createDirectories(folder.resolve("repository/org")).getParent();
    link(users, ours, "org");
    link(users.resolve("org"), ours.resolve("org"), "u2sa");
    return ours;
  }

  private static void link(Path from, Path to, String except) throws IOException {
    try (Stream<Path> children = Files.list(from)) {
      for (Path child : children.toList()) {
        if (!child.getFileName().toString().equals(except)) {
          Files.createSymbolicLink(to.resolve(child.getFileName()), child);
        }
      }
    }
  }

  private void maven(Path directory, Path repository, String... arguments)
      throws IOException, InterruptedException {
    Path output = folder.resolve("maven.txt");
    List<String> command =
        Stream.concat(
                Stream.of("mvn", "-o", "-B", "-q", "-Dmaven.repo.local=" + repository),
                Stream.of(arguments))
            .toList();
    Process process =
        new ProcessBuilder(command)
            .directory(directory.toFile())
            .redirectErrorStream(true)
            .redirectOutput(output.toFile())
            .start();
    assertThat(process.waitFor()).as(Files.readString(output)).isZero();
  }

  @Test
  void verify_generatedProject_succeeds() throws Exception {
    Path repository = repository();
    maven(
        ROOT,
        repository,
        "install",
        "-DskipTests",
        "-pl",
        "u2sa-estimation,u2sa-world,u2sa-mission,u2sa-planning,u2sa-control,u2sa-core,u2sa-bom",
        "-am");
    new NewProject(folder).make("vehicle", "boat");
    maven(folder.resolve("boat"), repository, "verify");
    assertThat(folder.resolve("boat/target/boat-1.0.jar")).exists();
    assertThat(folder.resolve("boat/target/surefire-reports")).isNotEmptyDirectory();
  }

  /** A project that uses the State Estimator alone, without launcher or Communication Manager. */
  @Test
  void verify_projectThatDependsOnEstimationAlone_succeeds() throws Exception {
    Path repository = repository();
    maven(ROOT, repository, "install", "-DskipTests", "-pl", "u2sa-estimation,u2sa-bom", "-am");
    new NewProject(folder).make("vehicle", "boat");
    Path project = Files.createDirectories(folder.resolve("consumer"));
    String pom = Files.readString(folder.resolve("boat/pom.xml"));
    Files.writeString(project.resolve("pom.xml"), OTHER_MODULES.matcher(pom).replaceAll(""));
    Path tests = Files.createDirectories(project.resolve("src/test/java"));
    Files.writeString(tests.resolve("EstimationTest.java"), ESTIMATION_TEST);
    maven(project, repository, "verify");
    assertThat(project.resolve("target/surefire-reports/TEST-EstimationTest.xml"))
        .content()
        .contains("tests=\"1\"");
  }
}
