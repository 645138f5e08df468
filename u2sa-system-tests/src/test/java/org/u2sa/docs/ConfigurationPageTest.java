package org.u2sa.docs;

import static java.util.stream.Collectors.joining;
import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.u2sa.control.VelocityControl;
import org.u2sa.control.fixedwing.ThesisControl;
import org.u2sa.control.ground.AckermannPursuitControl;
import org.u2sa.control.ground.DifferentialDriveControl;
import org.u2sa.control.ground.DifferentialPursuitControl;
import org.u2sa.core.communication.CommunicationManager;
import org.u2sa.core.launch.SystemFile;
import org.u2sa.device.CompassSensor;
import org.u2sa.device.GpsSensor;
import org.u2sa.device.ImuSensor;
import org.u2sa.device.LidarSensor;
import org.u2sa.device.RangeSensor;
import org.u2sa.device.WheelMotors;
import org.u2sa.drivers.ioio.IoioService;
import org.u2sa.drivers.mavlink.MavlinkAutopilot;
import org.u2sa.estimation.ComplementaryStateEstimator;
import org.u2sa.estimation.FusingStateEstimator;
import org.u2sa.interfaces.communication.LocalBus;
import org.u2sa.interfaces.configuration.Range;
import org.u2sa.interfaces.configuration.VariableDeclaration;
import org.u2sa.interfaces.configuration.XmlConfiguration;
import org.u2sa.messages.registry.StandardTypes;
import org.u2sa.planning.VectorFieldPlanner;
import org.u2sa.service.Actuator;
import org.u2sa.service.ServiceContext;
import org.u2sa.service.U2SAService;
import org.u2sa.vision.camera.CourseCamera;
import org.u2sa.vision.laser.ScanClusters;
import org.u2sa.world.WorldModeler;

/** docs/configuration.md lists the variables that the services really declare. */
class ConfigurationPageTest {
  private static final String MISSION = Page.ROOT.resolve("missions/cessna/mission.xml").toString();

  private static final String INTRODUCTION =
      """
      # Configuration

      Generated from the variables that the code declares; a test fails when this page is out of date, and
      this rewrites it:

      ```
      %s
      ```

      A service has one file, named in the system file ([config/cessna](../config/cessna) is an example):
      ```xml
      <configuration>
        <variable name="LOWEST ALTITUDE" type="double" value="150" unit="m"/>
      </configuration>
      ```
      - `type` is integer, double, boolean or string. `unit` may be any that converts to the unit below: `deg` for `rad`,
        `kt` for `m/s`, `ft` for `m`. Optional `min`, `max` and `description` are kept for ground stations.
      - A variable that is left out has its default; one that no service declares is refused, with the nearest known name.
      - `./u2sa run FILE --set "PathPlanner:LOOK AHEAD=120.0"` sets one for a run, in the unit below, without writing the file. The
        service is named by its class.
      - `./u2sa config set` changes them while the service runs and writes the file, `./u2sa config undo` takes that back
        ([remote-configuration.md](remote-configuration.md)). What a service reads in its constructor only is taken over at its next start.
      """;

  @TempDir Path logs;

  @Test
  void page_listsWhatServicesDeclare() throws Exception {
    Map<String, List<VariableDeclaration<?>>> services = new LinkedHashMap<>();
    SystemFile system = SystemFile.read(Page.ROOT.resolve("config/cessna/system.xml"));
    for (SystemFile.Entry entry : system.services()) {
      services.put(entry.simpleName(), declaredBy(Class.forName(entry.className())));
    }
    services.put("ComplementaryStateEstimator", declaredBy(ComplementaryStateEstimator.class));
    services.put("FusingStateEstimator", declaredBy(FusingStateEstimator.class));
    services.put("VectorFieldPlanner", declaredBy(VectorFieldPlanner.class));
    services.put("WorldModeler", declaredBy(WorldModeler.class));
    services.put("ThesisControl", declaredBy(ThesisControl.class));
    services.put("DifferentialPursuitControl", declaredBy(DifferentialPursuitControl.class));
    services.put("DifferentialDriveControl", declaredBy(DifferentialDriveControl.class));
    services.put("AckermannPursuitControl", declaredBy(AckermannPursuitControl.class));
    services.put("VelocityControl", declaredBy(VelocityControl.class));
    services.put("IoioService", declaredBy(IoioService.class));
    services.put("WheelMotors", declaredBy(WheelMotors.class));
    services.put("GpsSensor", declaredBy(GpsSensor.class));
    services.put("CompassSensor", declaredBy(CompassSensor.class));
    services.put("ImuSensor", declaredBy(ImuSensor.class));
    services.put("RangeSensor", declaredBy(RangeSensor.class));
    services.put("LidarSensor", declaredBy(LidarSensor.class));
    services.put("CourseCamera", declaredBy(CourseCamera.class));
    services.put("ScanClusters", declaredBy(ScanClusters.class));
    services.put("MavlinkAutopilot", declaredBy(MavlinkAutopilot.class));
    List<VariableDeclaration<?>> common = inAll(services.values());
    StringBuilder page = new StringBuilder(INTRODUCTION.formatted(Page.command()));
    section(page, "Every service", common, List.of());
    section(page, "CommunicationManager", declaredByManager(), List.of());
    services.forEach(
        (name, variables) -> {
          section(page, name, variables, common);
        });
    section(page, "Actuator", declaredBy(AnyActuator.class), common);
    new Page("docs/configuration.md").mustBe(page.toString());
  }

  /** A table of the variables that are not among the common ones. */
  private static void section(
      StringBuilder page,
      String heading,
      List<VariableDeclaration<?>> variables,
      List<VariableDeclaration<?>> common) {
    List<VariableDeclaration<?>> own = new ArrayList<>(variables);
    own.removeIf(variable -> names(common).contains(variable.name()));
    page.append("\n## ").append(heading).append("\n\n");
    if (own.isEmpty()) {
      page.append("No variables of its own.\n");
      return;
    }
    page.append(
        "| Variable | Type | Unit | Range | Default | Meaning |\n|---|---|---|---|---|---|\n");
    for (VariableDeclaration<?> variable : own) {
      assertThat(variable.description()).as("%s, %s", heading, variable).isNotEmpty();
      String choices =
          variable.choices().stream().map(ConfigurationPageTest::quoted).collect(joining(", "));
      cell(page, "`" + variable.name() + "`");
      cell(page, variable.type().xmlName());
      cell(page, variable.unit());
      cell(
          page,
          choices.isEmpty() && !variable.range().isAny() ? variable.range().toString() : choices);
      cell(page, variable.ifAbsent().map(ConfigurationPageTest::quoted).orElse("required"));
      cell(page, variable.description());
      page.append("|\n");
    }
  }

  private static void cell(StringBuilder page, String content) {
    String safe = content.replace("|", "\\|").replaceAll("\\s+", " ").trim();
    page.append("| ").append(safe).append(safe.isEmpty() ? "" : " ");
  }

  private static String quoted(Object value) {
    return value instanceof Double number
        ? Range.of(number, number).toString().split("…")[0]
        : value instanceof String ? "\"" + value + "\"" : String.valueOf(value);
  }

  /** An actuator that moves nothing. */
  public static final class AnyActuator extends Actuator {
    /** For the page. */
    public AnyActuator(ServiceContext context) {
      super(context, "Actuator");
    }

    @Override
    protected void actuate(double percentage) {}

    @Override
    protected void neutral() {}
  }

  private List<VariableDeclaration<?>> declaredBy(Class<?> service)
      throws ReflectiveOperationException {
    // None changes what is declared: some need a mission to begin with, drivers look for devices,
    // a camera is above the ground.
    XmlConfiguration configuration =
        XmlConfiguration.inMemory(
            "the page",
            Map.of(
                "MISSION",
                MISSION,
                "DEFAULT THRESHOLD",
                1.0,
                "CONNECTION",
                "tcp:127.0.0.1:9",
                "MOUNTED Z",
                -1.0));
    ServiceContext context =
        ServiceContext.of("docs", configuration)
            .transport(new LocalBus("docs"))
            .logDirectory(logs)
            .build();
    U2SAService made =
        service
            .asSubclass(U2SAService.class)
            .getConstructor(ServiceContext.class)
            .newInstance(context);
    made.kill();
    return configuration.declared();
  }

  private static List<VariableDeclaration<?>> declaredByManager() {
    XmlConfiguration configuration =
        XmlConfiguration.inMemory("the page", Map.of("BROKER", "none"));
    CommunicationManager.start("docs", configuration, StandardTypes.registry(), line -> {}).close();
    return configuration.declared();
  }

  private static List<VariableDeclaration<?>> inAll(
      Iterable<List<VariableDeclaration<?>>> services) {
    List<VariableDeclaration<?>> common = new ArrayList<>();
    for (List<VariableDeclaration<?>> variables : services) {
      if (common.isEmpty()) {
        common.addAll(variables);
      }
      common.removeIf(variable -> !names(variables).contains(variable.name()));
    }
    return common;
  }

  private static List<String> names(List<VariableDeclaration<?>> variables) {
    List<String> names = new ArrayList<>();
    variables.forEach(variable -> names.add(variable.name()));
    return names;
  }
}
