package org.u2sa.gcs.ros;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.u2sa.gcs.configuration.RemoteConfiguration;
import org.u2sa.gcs.remote.RemoteLink;
import org.u2sa.interfaces.BadInputException;
import org.u2sa.interfaces.JsonText;
import org.u2sa.messages.contract.ConfigurationAssignment;
import org.u2sa.messages.contract.ConfigurationResponse;
import org.u2sa.messages.contract.ConfigurationTransaction;
import org.u2sa.messages.contract.ConfigurationVariable;
import org.u2sa.report.message.JsonReader;

/**
 * Configuration variables as parameters: {@code /PathPlanner/LOOK_AHEAD} is {@code LOOK AHEAD} of
 * the service PathPlanner. Values are in the variable's own unit.
 */
final class RosParameters {
  private static final String VALUE = "value";

  /** A variable and its service's answer. */
  record Found(ConfigurationResponse service, ConfigurationVariable variable) {}

  private final RemoteLink link;

  RosParameters(RemoteLink link) {
    this.link = link;
  }

  private static String name(ConfigurationResponse service, ConfigurationVariable variable) {
    return "/" + service.serviceName() + "/" + variable.name().replace(' ', '_');
  }

  List<Object> names() throws InterruptedException {
    List<Object> names = new ArrayList<>();
    for (ConfigurationResponse service : new RemoteConfiguration(link).all()) {
      service.variables().forEach(variable -> names.add(name(service, variable)));
    }
    return names;
  }

  /** Finds a parameter; ROS 2 puts a colon between node and parameter. */
  Optional<Found> find(String name) throws InterruptedException {
    String wanted = ("/" + name).replace("//", "/").replace(':', '/');
    int slash = wanted.lastIndexOf('/');
    if (slash < 2) {
      return Optional.empty();
    }
    ConfigurationResponse service;
    try {
      service = new RemoteConfiguration(link).of(wanted.substring(1, slash));
    } catch (BadInputException e) {
      return Optional.empty(); // no such service
    }
    return service.variables().stream()
        .filter(variable -> name(service, variable).equals(wanted))
        .map(variable -> new Found(service, variable))
        .findFirst();
  }

  private Found known(String name) throws InterruptedException {
    return find(name)
        .orElseThrow(
            () ->
                new BadInputException(
                    "parameter \"" + name + "\": not found; /rosapi/get_param_names lists them"));
  }

  /** Value of a parameter as JSON. */
  String value(String name) throws InterruptedException {
    ConfigurationVariable variable = known(name).variable();
    boolean isText = variable.variableType().equals("string");
    return isText ? quoted(variable.value()) : variable.value();
  }

  private static String quoted(String text) {
    String object = new JsonText().put(VALUE, text).line();
    return object.substring(object.indexOf(':') + 1, object.length() - 1);
  }

  /**
   * Sets a parameter.
   *
   * @param json a number, boolean or text, which may have a unit: {@code "25 deg"}
   * @throws BadInputException if the parameter is unknown or the value has an unsupported type
   * @throws org.u2sa.interfaces.RunFailedException if the service refuses, with its reason
   */
  void set(String name, String json) throws InterruptedException {
    Found found = known(name);
    Map<String, Object> read =
        JsonReader.object("parameter \"" + name + "\"", "{\"" + VALUE + "\":" + json + "}");
    Object value = read.get(VALUE);
    if (read.size() != 1
        || value instanceof Map
        || value instanceof List
        || value instanceof Optional) {
      throw new BadInputException(
          "parameter \"" + name + "\": expected a number, true, false or a text, not " + json);
    }
    String service = found.service().serviceName();
    String text = RemoteConfiguration.inUnitOf(found.variable(), service, String.valueOf(value));
    new RemoteConfiguration(link)
        .change(
            new ConfigurationTransaction()
                .serviceName(service)
                .assignments(
                    List.of(
                        new ConfigurationAssignment()
                            .variableName(found.variable().name())
                            .value(text))));
  }
}
