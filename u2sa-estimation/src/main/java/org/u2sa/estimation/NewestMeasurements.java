package org.u2sa.estimation;

import java.util.ArrayList;
import java.util.Collection;
import java.util.Comparator;
import java.util.EnumMap;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import org.u2sa.messages.StateField;
import org.u2sa.messages.StateInformation;

/** Keeps the newest measurement of each sensor and combines them into a state. */
final class NewestMeasurements {
  private static final String SIGMA = "Sigma";
  private static final Map<StateField, StateField> SIGMAS = sigmas();

  private final long staleMicros;
  private final DeadReckoning reckoning;
  private final Map<String, StateInformation> bySensor = new HashMap<>();

  /**
   * @param staleMicros maximum age of a measurement relative to the newest one [µs]
   */
  NewestMeasurements(long staleMicros, DeadReckoning reckoning) {
    this.staleMicros = staleMicros;
    this.reckoning = reckoning;
  }

  /** Maps each field to the field of its standard deviation. */
  private static Map<StateField, StateField> sigmas() {
    Map<String, StateField> byName = new HashMap<>();
    for (StateField field : StateField.values()) {
      byName.put(field.fieldName(), field);
    }
    Map<StateField, StateField> sigmas = new EnumMap<>(StateField.class);
    for (StateField field : StateField.values()) {
      StateField sigma = byName.get(field.fieldName() + SIGMA);
      if (sigma != null) {
        sigmas.put(field, sigma);
      }
    }
    return sigmas;
  }

  /**
   * Adds a measurement and returns it, completed with the newest measurements of other sensors in
   * the same frame.
   *
   * @param sensed measurement, which must have a timestamp
   * @return empty if another sensor's measurement is newer, because the state must not go back in
   *     time; the measurement is then used for later states. Also empty for a measurement in a body
   *     frame while other sensors measure in an external frame
   */
  Optional<StateInformation> with(StateInformation sensed) {
    long now = sensed.timestamp().orElseThrow();
    bySensor.put(sensed.sensorName(), sensed);
    bySensor.values().removeIf(each -> now - micros(each) > staleMicros);
    List<StateInformation> others = new ArrayList<>();
    for (StateInformation each : bySensor.values()) {
      boolean isComparable =
          each.referenceFrame().equals(sensed.referenceFrame())
              && micros(each) - now <= staleMicros; // otherwise from a different clock
      if (each != sensed && isComparable) {
        others.add(each);
      }
    }
    boolean isLate = others.stream().anyMatch(other -> micros(other) > now);
    if (isLate || isOutshone(sensed)) {
      return Optional.empty();
    }
    others.sort(
        Comparator.comparingLong(NewestMeasurements::micros)
            .reversed()
            .thenComparing(each -> each.sensorName()));
    StateInformation state = OwnFields.with(sensed, others);
    others.forEach(other -> complete(state, reckoning.at(now, other)));
    return Optional.of(state);
  }

  /** Whether a body-frame measurement would displace the vehicle's position in the state. */
  private boolean isOutshone(StateInformation sensed) {
    return sensed.referenceFrame().isBody()
        && bySensor.values().stream().anyMatch(other -> !other.referenceFrame().isBody());
  }

  private static void complete(StateInformation state, StateInformation from) {
    SIGMAS.forEach(
        (field, sigma) -> {
          OptionalDouble value = from.number(field);
          if (value.isPresent() && state.number(field).isEmpty()) {
            state.number(field, value.getAsDouble());
            from.number(sigma).ifPresent(each -> state.number(sigma, each));
          }
        });
  }

  private static long micros(StateInformation measured) {
    return measured.timestamp().orElseThrow();
  }

  /** Newest measurement of each sensor, without stale ones. */
  Collection<StateInformation> all() {
    return bySensor.values();
  }

  /** Restores the measurements of another estimator. */
  void takeOver(Collection<StateInformation> measured) {
    measured.forEach(each -> bySensor.put(each.sensorName(), each));
  }
}
