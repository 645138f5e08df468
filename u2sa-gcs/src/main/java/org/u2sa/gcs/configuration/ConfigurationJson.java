package org.u2sa.gcs.configuration;

import java.math.BigDecimal;
import java.util.List;
import java.util.Optional;
import org.u2sa.interfaces.JsonText;
import org.u2sa.messages.contract.ConfigurationAssignment;
import org.u2sa.messages.contract.ConfigurationResponse;
import org.u2sa.messages.contract.ConfigurationTransactionResult;
import org.u2sa.messages.contract.ConfigurationVariable;

/** Formats configurations as JSON. Unknown values are omitted. */
public final class ConfigurationJson {
  private ConfigurationJson() {}

  public static String text(String systemId, List<ConfigurationResponse> services) {
    return new JsonText()
        .put("system", systemId)
        .put("services", services.stream().map(ConfigurationJson::of).toList())
        .toString();
  }

  private static JsonText of(ConfigurationResponse service) {
    return new JsonText()
        .put("name", service.serviceName())
        .put("revision", service.revision())
        .put("variables", service.variables().stream().map(ConfigurationJson::of).toList());
  }

  public static String text(ConfigurationVariable variable) {
    return of(variable).toString();
  }

  public static String text(ConfigurationTransactionResult result) {
    return new JsonText()
        .put("service", result.serviceName())
        .put("revision", result.revision())
        .put("changes", result.assignments().stream().map(ConfigurationJson::of).toList())
        .toString();
  }

  private static JsonText of(ConfigurationAssignment assignment) {
    return new JsonText()
        .put("variable", assignment.variableName())
        .put("old", assignment.previous().orElse(""))
        .put("new", assignment.value());
  }

  private static JsonText of(ConfigurationVariable variable) {
    return new JsonText()
        .put("name", variable.name())
        .put("type", variable.variableType())
        .put("value", value(variable))
        .put("unit", Optional.of(variable.unit()).filter(unit -> !unit.isEmpty()))
        .put("min", variable.min())
        .put("max", variable.max())
        .put("choices", Optional.of(variable.choices()).filter(choices -> !choices.isEmpty()))
        .put("description", variable.description());
  }

  private static Object value(ConfigurationVariable variable) {
    return switch (variable.variableType()) {
      case "double", "int" -> new BigDecimal(variable.value());
      case "boolean" -> Boolean.parseBoolean(variable.value());
      default -> variable.value();
    };
  }
}
