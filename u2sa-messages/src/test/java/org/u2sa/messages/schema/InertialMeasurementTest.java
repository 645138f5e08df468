package org.u2sa.messages.schema;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.u2sa.messages.InertialMeasurement;
import org.u2sa.messages.StateField;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.cbor.MalformedMessageException;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.messages.registry.StandardTypes;

class InertialMeasurementTest {
  private static InertialMeasurement measured() {
    InertialMeasurement measured =
        new InertialMeasurement().yawRate(0.25).angularRateSigma(0.01).specificForceZ(-9.8125);
    measured.sensorName("IMU").timestamp(1_000_000L);
    return measured;
  }

  @Test
  void frame_untilSet_isForwardRightDown() {
    assertThat(new InertialMeasurement().referenceFrame()).isEqualTo(ReferenceFrame.BODY_FRD);
  }

  @Test
  void presenceVector_ratesAndForcesOnly_hasNoneOfTheStatesBits() {
    assertThat(measured().presenceVector() & ((1L << StateField.values().length) - 1)).isZero();
  }

  @Test
  void decode_ownType_givesAllThatWasSet() throws MalformedMessageException {
    U2SAData read =
        new MessageCodec(StandardTypes.registry())
            .decode(measured().typeChain(), measured().serialize());

    assertThat(read).isEqualTo(measured()).isInstanceOf(InertialMeasurement.class);
  }

  @Test
  void decode_readerWithoutTheType_getsAStateInformation() throws MalformedMessageException {
    U2SAData read =
        new MessageCodec(MessageTypes.of(List.of(StateInformation.TYPE)))
            .decode(measured().typeChain(), measured().serialize());

    assertThat(read.getClass()).isEqualTo(StateInformation.class);
    StateInformation state = (StateInformation) read;
    assertThat(state.sensorName()).isEqualTo("IMU");
    assertThat(state.referenceFrame()).isEqualTo(ReferenceFrame.BODY_FRD);
  }

  @Test
  void angularRateSigma_negative_isRefused() {
    assertThatThrownBy(() -> new InertialMeasurement().angularRateSigma(-0.1))
        .isInstanceOf(IllegalArgumentException.class)
        .hasMessageContaining("angularRateSigma");
  }
}
