package org.u2sa.docs;

import static java.util.stream.Collectors.joining;
import static java.util.stream.Collectors.toList;
import static org.assertj.core.api.Assertions.assertThat;

import com.tngtech.archunit.core.domain.JavaClass;
import com.tngtech.archunit.core.domain.JavaModifier;
import com.tngtech.archunit.core.importer.ClassFileImporter;
import com.tngtech.archunit.core.importer.ImportOption;
import java.lang.reflect.Proxy;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.u2sa.core.communication.CommunicationManager;
import org.u2sa.core.launch.Launcher;
import org.u2sa.core.launch.SystemFile;
import org.u2sa.device.detection.ObjectDetector;
import org.u2sa.interfaces.communication.LocalBus;
import org.u2sa.interfaces.configuration.Range;
import org.u2sa.interfaces.configuration.VariableDeclaration;
import org.u2sa.interfaces.configuration.XmlConfiguration;
import org.u2sa.interfaces.time.Clock;
import org.u2sa.messages.registry.StandardTypes;
import org.u2sa.service.Actuator;
import org.u2sa.service.ServiceContext;
import org.u2sa.service.U2SAService;

/** docs/configuration.md lists the variables that the services really declare. */
class ConfigurationPageTest {
  private static final String MISSION = Page.ROOT.resolve("missions/cessna/mission.xml").toString();

  private static final String[] PACKAGES = {
    "org.u2sa.control",
    "org.u2sa.core",
    "org.u2sa.device",
    "org.u2sa.drivers",
    "org.u2sa.estimation",
    "org.u2sa.mission",
    "org.u2sa.planning",
    "org.u2sa.recorder",
    "org.u2sa.vision",
    "org.u2sa.world"
  };

  /** A detector that sees nothing: the only one with a driver is the simulated one. */
  private static final ServiceContext.DeviceSource DETECTOR =
      new ServiceContext.DeviceSource() {
        @Override
        public <D> Optional<D> device(
            Class<D> port, String service, XmlConfiguration variables, Clock clock) {
          return Optional.of(port)
              .filter(ObjectDetector.class::equals)
              .map(
                  detector ->
                      detector.cast(
                          Proxy.newProxyInstance(
                              detector.getClassLoader(),
                              new Class<?>[] {detector},
                              (proxy, method, arguments) ->
                                  method.getReturnType() == Optional.class
                                      ? Optional.empty()
                                      : null)));
        }
      };

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
      - Numbers, in the unit below, are 0 or of a magnitude from 10⁻¹² to 10¹², so that what is computed from them stays finite.
      - A variable that is left out has its default; one that no service declares is refused, with the nearest known name.
      - `./u2sa run FILE --set "PathPlanner:LOOK AHEAD=120.0"` sets one for a run, in the unit below, without writing the file. The
        service is named by its class.
      - `./u2sa config set` changes them while the service runs and writes the file, `./u2sa config undo` takes that back, to the value of `--set` if that was in force
        ([remote-configuration.md](remote-configuration.md)). What a service reads in its constructor only is taken over at its next start.
      """;

  @TempDir Path logs;

  @Test
  void page_listsWhatServicesDeclare() throws Exception {
    Map<Class<?>, List<VariableDeclaration<?>>> services = new LinkedHashMap<>();
    SystemFile system = SystemFile.read(Page.ROOT.resolve("config/cessna/system.xml"));
    for (SystemFile.Entry entry : system.services()) {
      Class<?> service = Class.forName(entry.className());
      services.put(service, declaredBy(service));
    }
    for (Class<?> service : others()) {
      if (!services.containsKey(service)) {
        services.put(service, declaredBy(service));
      }
    }
    List<VariableDeclaration<?>> common = inAll(services.values());
    StringBuilder page = new StringBuilder(INTRODUCTION.formatted(Page.command()));
    section(page, "Every service", "", common, List.of());
    section(page, "CommunicationManager", "", declaredByManager(), List.of());
    services.forEach(
        (service, variables) -> {
          String name = "`" + service.getName() + "`\n\n";
          section(page, service.getSimpleName(), name, variables, common);
        });
    section(page, "Actuator", "", declaredBy(AnyActuator.class), common);
    new Page("docs/configuration.md").mustBe(page.toString());
  }

  /** All services but those of demos, in the order of their names. */
  private static List<Class<?>> others() {
    return new ClassFileImporter()
        .withImportOption(new ImportOption.DoNotIncludeTests()).importPackages(PACKAGES).stream()
            .filter(each -> each.isAssignableTo(U2SAService.class))
            .filter(each -> !each.getModifiers().contains(JavaModifier.ABSTRACT))
            .filter(each -> !each.isEquivalentTo(Launcher.class)) // has none, and no file
            .sorted(Comparator.comparing(JavaClass::getSimpleName))
            .map(JavaClass::reflect)
            .collect(toList());
  }

  /** A table of the variables that are not among the common ones. */
  private static void section(
      StringBuilder page,
      String heading,
      String introduction,
      List<VariableDeclaration<?>> variables,
      List<VariableDeclaration<?>> common) {
    List<VariableDeclaration<?>> own = new ArrayList<>(variables);
    own.removeIf(variable -> names(common).contains(variable.name()));
    page.append("\n## ").append(heading).append("\n\n").append(introduction);
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
                "KIND",
                "LIGHT",
                "MASS",
                10.0,
                "ACTUATORS",
                "RELEASE=3",
                "MOUNTED Z",
                -1.0));
    ServiceContext context =
        ServiceContext.of("docs", configuration)
            .transport(new LocalBus("docs"))
            .logDirectory(logs)
            .devices(DETECTOR)
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
