package org.u2sa.gcs.mavlink.parameter;

import io.dronefleet.mavlink.common.MavParamType;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.u2sa.interfaces.JsonText;
import org.u2sa.messages.contract.ConfigurationResponse;
import org.u2sa.messages.contract.ConfigurationVariable;

/**
 * Description of each parameter for stations: text, unit, range and choices, in the format of
 * COMP_METADATA_TYPE_PARAMETER; without values.
 */
public final class ParameterMetadata {
  /** The only version that QGroundControl reads, although the schema says at least 3. */
  private static final int VERSION = 1;

  private ParameterMetadata() {}

  /**
   * Describes all parameters.
   *
   * @param configurations configuration of each service, by its name
   */
  public static String json(Map<String, ConfigurationResponse> configurations) {
    ParameterTable table = new ParameterTable(configurations);
    List<JsonText> parameters = new ArrayList<>();
    for (int i = 0; i < table.size(); i++) {
      parameters.add(of(table.at(i)));
    }
    return new JsonText().put("version", VERSION).put("parameters", parameters).line();
  }

  private static JsonText of(Parameter parameter) {
    ConfigurationVariable variable = parameter.variable();
    boolean isFloat = parameter.value().type() == MavParamType.MAV_PARAM_TYPE_REAL32;
    List<String> values =
        variable.variableType().equals("boolean") ? List.of("false", "true") : variable.choices();
    return new JsonText()
        .put("name", parameter.name())
        .put("type", isFloat ? "Float" : "Int32")
        .put("shortDesc", variable.name() + " of " + parameter.service())
        .put("longDesc", some(variable.description()))
        .put("units", some(variable.unit()))
        .put("min", variable.min())
        .put("max", variable.max())
        .put("group", parameter.service())
        .put("values", values.isEmpty() ? Optional.empty() : Optional.of(choices(values)));
  }

  private static Optional<String> some(String text) {
    return Optional.of(text).filter(each -> !each.isEmpty());
  }

  private static List<JsonText> choices(List<String> values) {
    List<JsonText> choices = new ArrayList<>();
    for (String each : values) {
      choices.add(new JsonText().put("value", choices.size()).put("description", each));
    }
    return choices;
  }
}
