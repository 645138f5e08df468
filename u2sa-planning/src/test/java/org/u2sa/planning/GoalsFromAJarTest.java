package org.u2sa.planning;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.tuple;

import java.io.IOException;
import java.net.URL;
import java.net.URLClassLoader;
import java.nio.file.FileSystem;
import java.nio.file.FileSystems;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import javax.tools.ToolProvider;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.messages.contract.ConfigurationVariable;
import org.u2sa.messages.goal.GoalInformation;
import org.u2sa.messages.mission.GoalClass;
import org.u2sa.messages.mission.MissionReport;
import org.u2sa.messages.mission.MissionRequest;
import org.u2sa.messages.schema.MessageType;

/** A class of goals, its planner state and its element in missions come from a jar (4.2.1.3). */
class GoalsFromAJarTest {
  private static final String GOAL =
      """
      package org.example.boat;

      import org.u2sa.messages.goal.Waypoint;
      import org.u2sa.messages.schema.MessageType;
      import org.u2sa.messages.schema.NumberField;
      import org.u2sa.messages.schema.Schema;

      public final class HulaHoop extends Waypoint {
        private static final Schema<HulaHoop> SCHEMA =
            Schema.of(HulaHoop.class, HulaHoop::new, Waypoint.TYPE);
        private static final NumberField<HulaHoop> SHOTS = SCHEMA.number("shots", "", 6.0);
        private static final NumberField<HulaHoop> FIRED = SCHEMA.number("fired", "", 0.0);
        public static final MessageType<HulaHoop> TYPE = SCHEMA.build();

        @Override
        public MessageType<HulaHoop> type() {
          return TYPE;
        }

        double shots() {
          return require(SHOTS);
        }

        double fired() {
          return require(FIRED);
        }

        HulaHoop fired(double value) {
          put(FIRED, value);
          return this;
        }
      }
      """;
  private static final String STATE =
      """
      package org.example.boat;

      import java.util.List;
      import org.u2sa.planning.Plan;
      import org.u2sa.planning.PlannerState;
      import org.u2sa.planning.Pursuit;
      import org.u2sa.messages.goal.GoalInformation;
      import org.u2sa.messages.StateInformation;

      final class HulaHoopState implements PlannerState {
        private HulaHoop goal;

        @Override
        public Class<? extends GoalInformation> goalClass() {
          return HulaHoop.class;
        }

        @Override
        public void enter(Pursuit pursuit) {
          goal = (HulaHoop) pursuit.goal().copy();
          goal.arrivedAt(pursuit.state().timestamp().orElseThrow());
        }

        @Override
        public double distanceM(GoalInformation other, StateInformation state) {
          return 0.0;
        }

        @Override
        public Plan plan(Pursuit pursuit) {
          goal.fired(goal.fired() + 1.0); // a shot each time
          Plan.Progress progress =
              goal.fired() >= goal.shots() ? Plan.Progress.COMPLETED : Plan.Progress.UNDER_WAY;
          return new Plan(List.of(), progress, "").changing(goal);
        }
      }
      """;
  private static final String PROVIDER =
      """
      package org.example.boat;

      import java.util.Collection;
      import java.util.List;
      import org.u2sa.planning.PlannerState;
      import org.u2sa.planning.PlannerStateProvider;
      import org.u2sa.planning.PlannerView;
      import org.u2sa.interfaces.configuration.Configurator;
      import org.u2sa.messages.schema.MessageType;
      import org.u2sa.messages.schema.MessageTypeProvider;

      public final class Provider implements MessageTypeProvider, PlannerStateProvider {
        @Override
        public Collection<MessageType<?>> messageTypes() {
          return List.of(HulaHoop.TYPE);
        }

        @Override
        public Collection<PlannerState> plannerStates(Configurator planner, PlannerView surroundings) {
          return List.of(new HulaHoopState());
        }
      }
      """;

  @TempDir private Path directory;

  private Path jar() throws IOException {
    Path sources = Files.createDirectories(directory.resolve("org/example/boat"));
    Files.writeString(sources.resolve("HulaHoop.java"), GOAL);
    Files.writeString(sources.resolve("HulaHoopState.java"), STATE);
    Files.writeString(sources.resolve("Provider.java"), PROVIDER);
    Path classes = Files.createDirectory(directory.resolve("classes"));
    int failed =
        ToolProvider.getSystemJavaCompiler()
            .run(
                null,
                null,
                null,
                "-proc:none",
                "-cp",
                System.getProperty("java.class.path"),
                "-d",
                classes.toString(),
                sources.resolve("HulaHoop.java").toString(),
                sources.resolve("HulaHoopState.java").toString(),
                sources.resolve("Provider.java").toString());
    assertThat(failed).isZero();
    Path jar = directory.resolve("boat.jar");
    try (FileSystem zip = FileSystems.newFileSystem(jar, Map.of("create", "true"))) {
      Path to = Files.createDirectories(zip.getPath("org/example/boat"));
      for (String name : List.of("HulaHoop", "HulaHoopState", "Provider")) {
        Files.copy(
            classes.resolve("org/example/boat/" + name + ".class"), to.resolve(name + ".class"));
      }
      Path services = Files.createDirectories(zip.getPath("META-INF/services"));
      for (String name :
          List.of(
              "org.u2sa.messages.schema.MessageTypeProvider",
              "org.u2sa.planning.PlannerStateProvider")) {
        Files.writeString(services.resolve(name), "org.example.boat.Provider\n");
      }
    }
    return jar;
  }

  @Test
  void mission_ofAClassFromAJar_isPursuedAndCarriesItsFieldsBack() throws IOException {
    Path file = directory.resolve("mission.xml");
    Files.writeString(
        file,
        """
        <mission>
          <hulaHoop><name>hoop</name><x>8</x><y>50</y><shots>4</shots></hulaHoop>
          <hulaHoop><name>again</name><x>8</x><y>50</y><repeat from="again" times="1"/></hulaHoop>
        </mission>
        """);
    Thread thread = Thread.currentThread();
    ClassLoader before = thread.getContextClassLoader();
    try (URLClassLoader loader = new URLClassLoader(new URL[] {jar().toUri().toURL()}, before)) {
      thread.setContextClassLoader(loader);
      try (TestDrive drive =
          new TestDrive(new TestRover(0, 0, 0), file.toString(), Map.of("REPORT INTERVAL", 1.0))) {
        assertThat(drive.until(drive::isMissionOver, 60.0)).isTrue();
        drive.kit.publish(Channels.MISSION, new MissionRequest().requestId("r"));
        MissionReport report = (MissionReport) drive.kit.latest(Channels.MISSION).orElseThrow();

        assertThat(report.goals())
            .extracting(goal -> field(goal, "fired"))
            .containsExactly(4.0, 6.0);
        assertThat(report.goals()).allMatch(GoalInformation::completed);
        assertThat(report.finished()).containsExactly(1.0, 2.0);

        drive.kit.publish(Channels.MISSION, new MissionRequest().requestId("c").classes(true));
        assertThat(drive.kit.published(Channels.MISSION))
            .filteredOn(GoalClass.class::isInstance)
            .extracting(GoalClass.class::cast)
            .filteredOn(each -> each.className().equals("HulaHoop"))
            .singleElement()
            .satisfies(
                hoop ->
                    assertThat(hoop.variables())
                        .extracting(ConfigurationVariable::name, ConfigurationVariable::value)
                        .contains(tuple("shots", "6.0"), tuple("x", "")));
      }
    } finally {
      thread.setContextClassLoader(before);
    }
  }

  @SuppressWarnings("unchecked")
  private static <T extends GoalInformation> Object field(T goal, String name) {
    var type = (MessageType<T>) goal.type();
    return type.field(name).orElseThrow().get(goal).orElseThrow();
  }
}
