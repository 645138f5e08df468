package org.u2sa.gcs.mavlink.telemetry;

import io.dronefleet.mavlink.common.BatteryStatus;
import io.dronefleet.mavlink.common.MavBatteryFunction;
import io.dronefleet.mavlink.common.MavBatteryType;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import org.u2sa.messages.BatteryState;

/** A battery state in MAVLink's units, with MAVLink's values for unknown quantities. */
final class BatteryMessages {
  private static final double MILLI = 1000.0;
  private static final double CENTI = 100.0;
  private static final int UNKNOWN_16 = 0xFFFF;
  private static final int CELLS = 10;

  private BatteryMessages() {}

  static int millivolts(Optional<BatteryState> battery) {
    return battery
        .map(BatteryState::voltage)
        .filter(OptionalDouble::isPresent)
        .map(volts -> (int) Math.min(UNKNOWN_16 - 1, Math.round(volts.getAsDouble() * MILLI)))
        .orElse(UNKNOWN_16);
  }

  static int centiamperes(Optional<BatteryState> battery) {
    return battery
        .map(BatteryState::current)
        .filter(OptionalDouble::isPresent)
        .map(
            amperes ->
                (int)
                    Math.max(
                        0, Math.min(Short.MAX_VALUE, Math.round(amperes.getAsDouble() * CENTI))))
        .orElse(-1);
  }

  static int percent(Optional<BatteryState> battery) {
    return battery
        .map(BatteryState::remaining)
        .filter(OptionalDouble::isPresent)
        .map(percent -> (int) Math.round(percent.getAsDouble()))
        .orElse(-1);
  }

  /** BATTERY_STATUS; cell 0 carries the total voltage. */
  static Optional<Object> status(Optional<BatteryState> battery) {
    return battery.map(
        state -> {
          List<Integer> cells = new ArrayList<>(Collections.nCopies(CELLS, UNKNOWN_16));
          cells.set(0, millivolts(battery));
          return BatteryStatus.builder()
              .id(0)
              .batteryFunction(MavBatteryFunction.MAV_BATTERY_FUNCTION_ALL)
              .type(MavBatteryType.MAV_BATTERY_TYPE_UNKNOWN)
              .temperature(Short.MAX_VALUE)
              .voltages(cells)
              .currentBattery(centiamperes(battery))
              .currentConsumed(-1)
              .energyConsumed(-1)
              .batteryRemaining(percent(battery))
              .voltagesExt(List.of(0, 0, 0, 0))
              .build();
        });
  }
}
