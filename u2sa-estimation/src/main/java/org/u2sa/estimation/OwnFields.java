package org.u2sa.estimation;

import java.util.Collection;
import org.u2sa.messages.InertialMeasurement;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.schema.MessageField;
import org.u2sa.messages.schema.MessageType;

/** What one sensor says beyond what every state has, such as whether weight is on the wheels. */
final class OwnFields {
  private OwnFields() {}

  /**
   * A copy of a state. Where a sensor says more than any state has, it is a message of that one's
   * class, with what only that one says.
   *
   * @param sensors the first that says more counts
   */
  static StateInformation with(StateInformation state, Collection<StateInformation> sensors) {
    if (state.getClass() == StateInformation.class) {
      for (StateInformation sensor : sensors) {
        if (isRicher(sensor)) {
          return of(sensor.type(), sensor, state);
        }
      }
    }
    return state.copy();
  }

  /** Rates and forces are measurements, which are no part of a state. */
  static boolean isRicher(StateInformation sensor) {
    return sensor.getClass() != StateInformation.class && !(sensor instanceof InertialMeasurement);
  }

  private static <T extends StateInformation> StateInformation of(
      MessageType<T> type, StateInformation sensor, StateInformation state) {
    T to = type.create();
    T rich = type.messageClass().cast(sensor);
    for (MessageField<T> field : type.fields()) {
      if (StateInformation.TYPE.field(field.name()).isEmpty() && field.isSet(rich)) {
        field.get(rich).ifPresent(value -> field.set(to, value));
      }
    }
    for (MessageField<StateInformation> field : StateInformation.TYPE.fields()) {
      if (field.isSet(state)) {
        field.get(state).ifPresent(value -> field.set(to, value));
      }
    }
    return to;
  }
}
