package org.u2sa.estimation;

import java.util.Collection;
import org.u2sa.messages.InertialMeasurement;
import org.u2sa.messages.LandmarkSighting;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.schema.MessageField;
import org.u2sa.messages.schema.MessageType;

/** Passes on sensor fields beyond the common state fields, such as weight on wheels. */
final class OwnFields {
  private OwnFields() {}

  /**
   * Copies a state. If a sensor's message class has additional fields, the copy has that class and
   * includes these fields.
   *
   * @param sensors sensors' messages; the first one with additional fields is used
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

  /**
   * Whether a sensor has additional fields. Angular rates, specific forces and landmarks do not
   * count: they are not part of a state.
   */
  static boolean isRicher(StateInformation sensor) {
    return sensor.getClass() != StateInformation.class
        && !(sensor instanceof InertialMeasurement)
        && !(sensor instanceof LandmarkSighting);
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
