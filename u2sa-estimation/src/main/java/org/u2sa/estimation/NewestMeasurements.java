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

/** The newest measurement of each sensor, and the state that they make together. */
final class NewestMeasurements {
  private static final String SIGMA = "Sigma";
  private static final Map<StateField, StateField> SIGMAS = sigmas();

  private final long staleMicros;
  private final DeadReckoning reckoning;
  private final Map<String, StateInformation> bySensor = new HashMap<>();

  /**
   * @param staleMicros older than the newest by more, a measurement no longer counts [µs]
   */
  NewestMeasurements(long staleMicros, DeadReckoning reckoning) {
    this.staleMicros = staleMicros;
    this.reckoning = reckoning;
  }

  /** Which number says how sure each number is. */
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
   * The state with one more measurement: that measurement, and what it lacks from the newest ones
   * of other sensors in the same frame.
   *
   * @param sensed has a timestamp
   * @return empty if another sensor measured later: the state would go back in time. What was
   *     sensed counts from the next measurement on. Empty, too, for what is measured along the
   *     vehicle's own axes while others know where it is
   */
  Optional<StateInformation> with(StateInformation sensed) {
    long now = sensed.timestamp().orElseThrow();
    bySensor.put(sensed.sensorName(), sensed);
    bySensor.values().removeIf(each -> now - micros(each) > staleMicros);
    List<StateInformation> others = new ArrayList<>();
    for (StateInformation each : bySensor.values()) {
      boolean isComparable =
          each.referenceFrame().equals(sensed.referenceFrame())
              && micros(each) - now <= staleMicros; // else another clock's
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

  /** Speeds of wheels, say, would take the place of the vehicle's position on the state channel. */
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

  /** The newest of each sensor that counts still. */
  Collection<StateInformation> all() {
    return bySensor.values();
  }

  /** Goes on from what another estimator had heard. */
  void takeOver(Collection<StateInformation> measured) {
    measured.forEach(each -> bySensor.put(each.sensorName(), each));
  }
}
