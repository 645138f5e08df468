package org.u2sa.cli.describe;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.u2sa.cli.describe.VehicleComposition.AnnouncedActuator;
import org.u2sa.cli.describe.VehicleComposition.ComposedService;
import org.u2sa.core.launch.PlannedService;
import org.u2sa.core.launch.SystemFile;
import org.u2sa.interfaces.communication.Channel;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.interfaces.xml.XmlElement;
import org.u2sa.interfaces.xml.XmlReader;
import org.u2sa.messages.contract.ConfigurationVariable;

/** Determines a vehicle's composition from its system file alone. */
final class CompositionOfFile {
  private static final List<Channel<?>> MEASURED =
      List.of(Channels.SENSED_STATE, Channels.SENSED_OBJECTS, Channels.SCANS);
  private static final String DRIVER = "Kind of "; // as in Devices' description

  private CompositionOfFile() {}

  /**
   * @throws IOException if the services cannot be created because their log files cannot
   */
  static VehicleComposition of(SystemFile system) throws IOException {
    List<ComposedService> services = new ArrayList<>();
    List<AnnouncedActuator> actuators = new ArrayList<>();
    for (PlannedService planned : PlannedService.of(system)) {
      Optional<Path> file = planned.entry().configuration();
      services.add(
          new ComposedService(
              planned.name(),
              planned.role(),
              planned.entry().className(),
              file.map(Path::toString).orElse(""),
              file.map(CompositionOfFile::variables).orElse(Map.of()),
              stated(planned),
              names(planned.publishes()),
              names(planned.subscribes()),
              planned.refusal().map(why -> "could not be created here: " + why).orElse("")));
      planned.actuators().forEach(each -> actuators.add(AnnouncedActuator.of(each)));
    }
    return new VehicleComposition(
        system.systemId(),
        system.file().toString(),
        false,
        system.autonomy(),
        services,
        List.of(),
        actuators);
  }

  private static Map<String, String> variables(Path file) {
    Map<String, String> variables = new LinkedHashMap<>();
    for (XmlElement variable : XmlReader.read(file, "configuration").children("variable")) {
      String unit = variable.optionalAttribute("unit").map(each -> " " + each).orElse("");
      variables.put(
          variable.attribute("name"), variable.optionalAttribute("value").orElse("") + unit);
    }
    return variables;
  }

  private static List<String> names(List<Channel<?>> channels) {
    return channels.stream().map(Channel::name).toList();
  }

  /**
   * Properties of a sensor's data by variable, with unit: device, standard deviations, rate,
   * mounting; empty for other services.
   */
  private static Map<String, String> stated(PlannedService service) {
    Map<String, String> stated = new LinkedHashMap<>();
    if (MEASURED.stream().anyMatch(service.publishes()::contains)) {
      for (ConfigurationVariable each : service.variables()) {
        if (isOfData(each)) {
          stated.put(each.name(), value(each) + (each.unit().isEmpty() ? "" : " " + each.unit()));
        }
      }
    }
    return stated;
  }

  private static String value(ConfigurationVariable variable) {
    return variable.variableType().equals("double")
        ? SourceRecord.text(Double.valueOf(variable.value()))
        : variable.value();
  }

  private static boolean isOfData(ConfigurationVariable variable) {
    String name = variable.name();
    boolean isPlace = name.startsWith("MOUNTED ") && Double.parseDouble(variable.value()) != 0.0;
    return isPlace
        || name.endsWith("SIGMA")
        || name.equals("CONNECTION")
        || name.endsWith("RATE") && variable.unit().equals("Hz")
        || variable.description().startsWith(DRIVER);
  }
}
