package org.u2sa.gcs.mavlink.parameter;

import io.dronefleet.mavlink.common.MavParamType;
import io.dronefleet.mavlink.common.MavSeverity;
import io.dronefleet.mavlink.common.ParamRequestList;
import io.dronefleet.mavlink.common.ParamRequestRead;
import io.dronefleet.mavlink.common.ParamSet;
import io.dronefleet.mavlink.common.ParamValue;
import java.util.List;
import java.util.Optional;
import org.u2sa.gcs.mavlink.station.GroundStation;
import org.u2sa.gcs.mavlink.vehicle.VehicleOrders;
import org.u2sa.gcs.mavlink.vehicle.VehicleStatus;
import org.u2sa.messages.contract.ConfigurationAssignment;
import org.u2sa.messages.contract.ConfigurationTransaction;

/**
 * Parameter protocol for one station (mavlink.io/en/services/parameter). Count and indices stay the
 * same from one request of the list to the next.
 */
public final class ParameterService {
  private static final String HASH_CHECK = "_HASH_CHECK";
  private static final int PER_STEP = 10;
  private static final int NO_INDEX = 0xFFFF;

  private final VehicleStatus vehicle;
  private final VehicleOrders orders;
  private final GroundStation station;
  private final boolean casts;
  private ParameterTable table;
  private long tableMicros = Long.MIN_VALUE; // number of configurations received when it was made
  private int next = Integer.MAX_VALUE; // index in the list being sent

  /**
   * @param casts whether integers travel cast to float
   */
  public ParameterService(
      VehicleStatus vehicle, VehicleOrders orders, GroundStation station, boolean casts) {
    this.vehicle = vehicle;
    this.orders = orders;
    this.station = station;
    this.casts = casts;
    table = new ParameterTable(vehicle.configurations().byService());
  }

  /** Handles a message; false if it does not belong to this protocol. */
  public boolean handle(Object message) {
    if (message instanceof ParamRequestList) {
      renew();
      next = 0;
    } else if (message instanceof ParamRequestRead request) {
      read(request);
    } else if (message instanceof ParamSet request) {
      set(request);
    } else {
      return false;
    }
    return true;
  }

  private void renew() {
    long changes = vehicle.configurations().changes();
    if (changes != tableMicros) {
      tableMicros = changes;
      table = new ParameterTable(vehicle.configurations().byService());
    }
  }

  /** Sends the next part of the list, and values that have changed. */
  public void step() {
    for (int sent = 0; sent < PER_STEP && next < table.size() && station.hasRoom(); sent++) {
      send(next++);
    }
    if (next >= table.size() && vehicle.configurations().changes() != tableMicros) {
      ParameterTable before = table;
      renew();
      tellChanges(before);
    }
  }

  private void tellChanges(ParameterTable before) {
    for (int i = 0; i < table.size(); i++) {
      Optional<Integer> known = before.index(table.at(i).name());
      if (known.isPresent() && !before.at(known.get()).value().equals(table.at(i).value())) {
        send(i);
      }
    }
  }

  private void read(ParamRequestRead request) {
    renew();
    int index = request.paramIndex();
    if (index >= 0) {
      if (index < table.size()) {
        send(index);
      }
      return;
    }
    String name = name(request.paramId());
    if (name.equals(HASH_CHECK)) {
      station.send(
          ParamValue.builder()
              .paramId(HASH_CHECK)
              .paramValue(Float.intBitsToFloat(table.hash(casts)))
              .paramType(MavParamType.MAV_PARAM_TYPE_UINT32)
              .paramCount(table.size())
              .paramIndex(NO_INDEX)
              .build());
      return;
    }
    table.index(name).ifPresent(this::send); // there is no answer for unknown names
  }

  /** A name on the wire ends at its first zero. */
  private static String name(String wire) {
    int end = wire.indexOf('\0');
    return end < 0 ? wire : wire.substring(0, end);
  }

  private void set(ParamSet request) {
    renew();
    String name = name(request.paramId());
    Optional<Integer> index = table.index(name);
    if (index.isEmpty()) {
      station.text(MavSeverity.MAV_SEVERITY_WARNING, "no parameter \"" + name + "\"");
      return;
    }
    Parameter parameter = table.at(index.get());
    double number =
        ParameterEncoding.decode(request.paramValue(), request.paramType().entry(), casts);
    if (parameter.has(number)) {
      send(index.get());
      return;
    }
    Optional<String> text = parameter.text(number);
    if (text.isEmpty()) {
      refuse(parameter, number + ": expected " + parameter.expectation());
      return;
    }
    orders.configure(
        new ConfigurationTransaction()
            .serviceName(parameter.service())
            .assignments(
                List.of(
                    new ConfigurationAssignment()
                        .variableName(parameter.variable().name())
                        .value(text.get()))),
        (accepted, reason) -> {
          if (accepted) {
            renew();
            table.index(name).ifPresent(this::send); // stations take it as the answer
          } else {
            refuse(parameter, reason);
          }
        });
  }

  private void refuse(Parameter parameter, String reason) {
    station.text(MavSeverity.MAV_SEVERITY_ERROR, parameter + " not set: " + reason);
    table.index(parameter.name()).ifPresent(this::send);
  }

  private void send(int index) {
    Parameter parameter = table.at(index);
    Parameter.Value value = parameter.value();
    station.send(
        ParamValue.builder()
            .paramId(parameter.name())
            .paramValue(ParameterEncoding.encode(value, casts))
            .paramType(value.type())
            .paramCount(table.size())
            .paramIndex(index)
            .build());
  }
}
