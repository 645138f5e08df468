package org.u2sa.cli.describe;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.u2sa.core.launch.PlannedService;
import org.u2sa.interfaces.communication.Channel;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.messages.contract.ConfigurationVariable;

/**
 * Properties of a sensor's data from its configuration: device, standard deviations, rate,
 * mounting.
 */
final class StatedSensor {
  private static final List<Channel<?>> MEASURED =
      List.of(Channels.SENSED_STATE, Channels.SENSED_OBJECTS, Channels.SCANS);
  private static final String DRIVER = "Kind of "; // as in Devices' description

  private StatedSensor() {}

  /** Values by variable, with unit; empty for a service that is not a sensor. */
  static Map<String, String> of(PlannedService service) {
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
