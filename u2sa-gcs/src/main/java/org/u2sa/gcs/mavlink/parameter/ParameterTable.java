package org.u2sa.gcs.mavlink.parameter;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeMap;
import org.u2sa.mavlink.MavlinkCrc32;
import org.u2sa.messages.contract.ConfigurationResponse;
import org.u2sa.messages.contract.ConfigurationVariable;

/** All parameters in the order of their names; indices are dense. Immutable. */
final class ParameterTable {
  private final List<Parameter> parameters;
  private final Map<String, Integer> indices = new HashMap<>();

  /**
   * @param configurations configuration of each service, by its name
   */
  ParameterTable(Map<String, ConfigurationResponse> configurations) {
    Map<String, Parameter> byName = new TreeMap<>();
    Set<String> taken = new HashSet<>();
    for (ConfigurationResponse each : new TreeMap<>(configurations).values()) {
      for (ConfigurationVariable variable : each.variables()) {
        if (Parameter.isExpressible(variable)) {
          String name = ParameterNames.of(each.serviceName(), variable.name(), taken);
          if (taken.add(name)) {
            byName.put(name, new Parameter(name, each.serviceName(), variable));
          }
        }
      }
    }
    parameters = new ArrayList<>(byName.values());
    for (int i = 0; i < parameters.size(); i++) {
      indices.put(parameters.get(i).name(), i);
    }
  }

  int size() {
    return parameters.size();
  }

  Parameter at(int index) {
    return parameters.get(index);
  }

  /** Index of a name; empty if it is unknown. */
  Optional<Integer> index(String name) {
    return Optional.ofNullable(indices.get(name));
  }

  /** PX4's _HASH_CHECK: CRC-32 over the names and value bytes in the order of the names. */
  int hash(boolean casts) {
    MavlinkCrc32 crc = new MavlinkCrc32();
    for (Parameter each : parameters) {
      crc.update(each.name().getBytes(StandardCharsets.US_ASCII));
      float value = ParameterEncoding.encode(each.value(), casts);
      crc.update(
          ByteBuffer.allocate(Float.BYTES).order(ByteOrder.LITTLE_ENDIAN).putFloat(value).array());
    }
    return crc.value();
  }
}
