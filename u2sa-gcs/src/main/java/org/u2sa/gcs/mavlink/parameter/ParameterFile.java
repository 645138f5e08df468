package org.u2sa.gcs.mavlink.parameter;

import io.dronefleet.mavlink.common.MavParamType;
import io.dronefleet.mavlink.util.EnumValue;
import java.math.BigDecimal;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeMap;
import java.util.regex.Pattern;
import org.u2sa.interfaces.BadInputException;
import org.u2sa.interfaces.xml.NearestNames;
import org.u2sa.messages.contract.ConfigurationAssignment;
import org.u2sa.messages.contract.ConfigurationResponse;
import org.u2sa.messages.contract.ConfigurationTransaction;
import org.u2sa.messages.contract.ConfigurationVariable;

/**
 * Parameter files of ground stations: QGroundControl's {@code .params} (vehicle, component, name,
 * value, type, separated by tabs), and the {@code .parm} of Mission Planner and MAVProxy (name and
 * value, separated by a comma or spaces).
 */
public final class ParameterFile {
  private static final int QGC_COLUMNS = 5;
  private static final int MAX_REFUSALS = 10;
  private static final int LONGEST_REFUSAL = 300; // characters
  private static final int LONGEST_NUMBER = 60; // characters
  private static final Pattern NUMBER =
      Pattern.compile("[-+]?([0-9]*\\.?[0-9]+|[0-9]+\\.)([eE][-+]?[0-9]+)?");

  private final ParameterTable table;

  /**
   * @param configurations of all services
   */
  public ParameterFile(List<ConfigurationResponse> configurations) {
    Map<String, ConfigurationResponse> byService = new TreeMap<>();
    configurations.forEach(each -> byService.put(each.serviceName(), each));
    table = new ParameterTable(byService);
  }

  /** Number of parameters. */
  public int size() {
    return table.size();
  }

  /** All parameters as {@code .parm}. */
  public String parm() {
    StringBuilder text = new StringBuilder();
    for (int i = 0; i < table.size(); i++) {
      text.append(table.at(i).name()).append(',').append(number(table.at(i))).append('\n');
    }
    return text.toString();
  }

  /** All parameters as {@code .params}. */
  public String params() {
    StringBuilder text = new StringBuilder("# Onboard parameters of U2SA\n#\n");
    text.append("# Vehicle-Id Component-Id Name Value Type\n");
    for (int i = 0; i < table.size(); i++) {
      int type = EnumValue.of(table.at(i).value().type()).value();
      text.append("1\t1\t").append(table.at(i).name());
      text.append('\t').append(number(table.at(i))).append('\t').append(type).append('\n');
    }
    return text.toString();
  }

  private static String number(Parameter parameter) {
    Parameter.Value value = parameter.value();
    return value.type() == MavParamType.MAV_PARAM_TYPE_REAL32
        ? Double.toString(value.number())
        : Long.toString((long) value.number());
  }

  /**
   * Changes made by a file, one transaction per service; parameters that already have their value
   * are left out.
   *
   * @param origin name of the file, for errors
   * @throws BadInputException naming every line with an unknown parameter or an invalid value
   */
  public List<ConfigurationTransaction> changes(String origin, String text) {
    List<String> refusals = new ArrayList<>();
    Set<String> seen = new HashSet<>();
    Map<String, List<ConfigurationAssignment>> byService = new TreeMap<>();
    String[] lines = text.split("\r\n|\n|\r", -1);
    for (int i = 0; i < lines.length && refusals.size() < MAX_REFUSALS; i++) {
      String line = lines[i].replaceFirst("#.*", "").trim();
      if (line.isEmpty()) {
        continue;
      }
      try {
        String[] pair = pair(line);
        if (!seen.add(pair[0])) {
          throw new IllegalArgumentException("\"" + pair[0] + "\" is given twice");
        }
        Parameter parameter = parameter(pair[0]);
        change(parameter, pair[1])
            .ifPresent(
                each ->
                    byService
                        .computeIfAbsent(parameter.service(), key -> new ArrayList<>())
                        .add(each));
      } catch (IllegalArgumentException e) {
        refusals.add(origin + ", line " + (i + 1) + ": " + shortened(e.getMessage()));
      }
    }
    if (!refusals.isEmpty()) {
      throw new BadInputException(String.join("\n", refusals));
    }
    List<ConfigurationTransaction> changes = new ArrayList<>();
    byService.forEach(
        (service, assignments) ->
            changes.add(
                new ConfigurationTransaction().serviceName(service).assignments(assignments)));
    return changes;
  }

  private static String shortened(String text) {
    return text.length() <= LONGEST_REFUSAL ? text : text.substring(0, LONGEST_REFUSAL) + "…";
  }

  private static String[] pair(String line) {
    String[] columns = line.split("[,\\s]+");
    if (columns.length == QGC_COLUMNS) {
      if (!columns[1].equals("1")) {
        throw new IllegalArgumentException(
            "component \"" + columns[1] + "\": expected 1, the autopilot");
      }
      return new String[] {columns[2], columns[3]};
    }
    if (columns.length != 2) {
      throw new IllegalArgumentException(
          "\""
              + line
              + "\": expected NAME,VALUE, or vehicle, component, name, value and type separated by"
              + " tabs");
    }
    return columns;
  }

  private Parameter parameter(String name) {
    Optional<Integer> index = table.index(name);
    if (index.isEmpty()) {
      List<String> names = new ArrayList<>();
      for (int i = 0; i < table.size(); i++) {
        names.add(table.at(i).name());
      }
      throw new IllegalArgumentException(
          "no parameter \"" + name + "\"" + NearestNames.didYouMean(name, names));
    }
    return table.at(index.get());
  }

  private static Optional<ConfigurationAssignment> change(Parameter parameter, String text) {
    if (text.length() > LONGEST_NUMBER || !NUMBER.matcher(text).matches()) {
      throw new IllegalArgumentException(
          parameter.name() + " \"" + text + "\": expected " + parameter.expectation());
    }
    double number = Double.parseDouble(text);
    Optional<String> value = parameter.text(number);
    if (value.isEmpty()) {
      throw new IllegalArgumentException(
          parameter.name() + " " + text + ": expected " + parameter.expectation());
    }
    requireRange(parameter, number);
    if (parameter.has(number)) {
      return Optional.empty();
    }
    boolean isExact = number == (float) number; // a station writes 0.1f as 0.100000001490116
    boolean isFloat = parameter.value().type() == MavParamType.MAV_PARAM_TYPE_REAL32;
    return Optional.of(
        new ConfigurationAssignment()
            .variableName(parameter.variable().name())
            .value(isFloat && !isExact ? BigDecimal.valueOf(number).toPlainString() : value.get()));
  }

  private static void requireRange(Parameter parameter, double number) {
    ConfigurationVariable variable = parameter.variable();
    if (variable.choices().isEmpty()
        && (number < variable.min().orElse(number) || number > variable.max().orElse(number))) {
      throw new IllegalArgumentException(
          String.format(
              Locale.ROOT,
              "%s %s: expected %s…%s%s",
              parameter.name(),
              number,
              variable.min().isPresent() ? variable.min().getAsDouble() : "",
              variable.max().isPresent() ? variable.max().getAsDouble() : "",
              variable.unit().isEmpty() ? "" : " " + variable.unit()));
    }
  }
}
