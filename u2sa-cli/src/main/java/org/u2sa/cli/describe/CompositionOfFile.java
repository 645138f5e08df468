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
import org.u2sa.interfaces.xml.XmlElement;
import org.u2sa.interfaces.xml.XmlReader;

/** Determines a vehicle's composition from its system file alone. */
final class CompositionOfFile {
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
              StatedSensor.of(planned),
              names(planned.publishes()),
              names(planned.subscribes()),
              planned.refusal().map(why -> "could not be made here: " + why).orElse("")));
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
    List<String> names = new ArrayList<>();
    channels.forEach(channel -> names.add(channel.name()));
    return names;
  }
}
