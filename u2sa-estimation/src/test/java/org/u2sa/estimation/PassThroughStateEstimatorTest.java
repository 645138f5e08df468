package org.u2sa.estimation;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.OptionalDouble;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.messages.StateField;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.messages.schema.MessageType;
import org.u2sa.messages.schema.NumberField;
import org.u2sa.messages.schema.Schema;
import org.u2sa.testkit.ServiceKit;

class PassThroughStateEstimatorTest {
  private final ServiceKit kit = new ServiceKit();

  @AfterEach
  void close() {
    kit.close();
  }

  @Test
  void callback_someFieldsPresent_theseAndNoOthersAreCopied() {
    kit.start(PassThroughStateEstimator::new);
    StateInformation sensed =
        new StateInformation()
            .sensorName("GPS")
            .referenceFrame(ReferenceFrame.LOCAL_NED)
            .x(1.0)
            .zDot(0.0)
            .number(StateField.PSI_DOUBLE_DOT_SIGMA, 3.0);
    sensed.timestamp(-7L);
    kit.publish(Channels.SENSED_STATE, sensed);

    StateInformation state = kit.latest(Channels.STATE).orElseThrow();
    assertThat(state).isNotSameAs(sensed);
    assertThat(state.presenceVector()).isEqualTo(sensed.presenceVector());
    for (StateField field : StateField.values()) {
      assertThat(state.number(field)).as(field.fieldName()).isEqualTo(sensed.number(field));
    }
    assertThat(state.referenceFrame()).isEqualTo(ReferenceFrame.LOCAL_NED);
    assertThat(state.timestamp()).hasValue(-7L);
    assertThat(state.sensorName()).isEqualTo("StateEstimator");
  }

  @Test
  void callback_subclassOfState_staysWhole() {
    kit.start(PassThroughStateEstimator::new);
    kit.publish(Channels.SENSED_STATE, new BatteryState().voltage(12.5));

    assertThat(kit.latest(Channels.STATE).orElseThrow())
        .isInstanceOfSatisfying(
            BatteryState.class, state -> assertThat(state.voltage()).hasValue(12.5));
  }

  /** An extension of the state, as a vehicle's module would write it. */
  static final class BatteryState extends StateInformation {
    private static final Schema<BatteryState> SCHEMA =
        Schema.of("BatteryState", BatteryState.class, BatteryState::new, StateInformation.TYPE);
    private static final NumberField<BatteryState> VOLTAGE = SCHEMA.optionalNumber("voltage", "V");
    private static final MessageType<BatteryState> TYPE = SCHEMA.build();

    @Override
    public MessageType<BatteryState> type() {
      return TYPE;
    }

    OptionalDouble voltage() {
      return get(VOLTAGE);
    }

    BatteryState voltage(double volts) {
      put(VOLTAGE, volts);
      return this;
    }
  }
}
