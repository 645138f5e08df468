package org.u2sa.gcs.configuration;

import java.util.ArrayList;
import java.util.List;
import java.util.OptionalDouble;
import org.u2sa.gcs.terminal.TextTable;
import org.u2sa.messages.contract.ConfigurationResponse;
import org.u2sa.messages.contract.ConfigurationVariable;

/** Configurations as a table for people. */
final class ConfigurationTable {
  private static final double WHOLE_BELOW = 1.0e15;

  private ConfigurationTable() {}

  /** A head line for each service, then its variables. */
  static List<String> lines(List<ConfigurationResponse> services) {
    List<String> lines = new ArrayList<>();
    for (ConfigurationResponse service : services) {
      if (!lines.isEmpty()) {
        lines.add("");
      }
      String revision =
          service.revision().isPresent()
              ? " (revision " + service.revision().getAsLong() + ")"
              : "";
      lines.add(service.serviceName() + revision);
      TextTable table = new TextTable("VARIABLE", "VALUE", "TYPE", "ALLOWED", "MEANING");
      for (ConfigurationVariable variable : service.variables()) {
        table.add(
            variable.name(),
            value(variable),
            variable.variableType(),
            allowed(variable),
            variable.description());
      }
      table.lines().forEach(line -> lines.add("  " + line));
    }
    return lines;
  }

  /** The value with its unit. */
  static String value(ConfigurationVariable variable) {
    return variable.unit().isEmpty() ? variable.value() : variable.value() + " " + variable.unit();
  }

  private static String allowed(ConfigurationVariable variable) {
    if (!variable.choices().isEmpty()) {
      return String.join(" | ", variable.choices());
    }
    OptionalDouble min = variable.min();
    OptionalDouble max = variable.max();
    if (min.isPresent() && max.isPresent()) {
      return number(min.getAsDouble()) + "…" + number(max.getAsDouble());
    }
    if (min.isPresent()) {
      return "from " + number(min.getAsDouble());
    }
    return max.isPresent() ? "up to " + number(max.getAsDouble()) : "";
  }

  private static String number(double value) {
    return value == Math.rint(value) && Math.abs(value) < WHOLE_BELOW
        ? Long.toString((long) value)
        : Double.toString(value);
  }
}
