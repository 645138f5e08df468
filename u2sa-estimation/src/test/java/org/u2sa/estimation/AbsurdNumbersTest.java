package org.u2sa.estimation;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import java.util.OptionalDouble;
import java.util.function.Consumer;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.messages.InertialMeasurement;
import org.u2sa.messages.StateField;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.contract.HealthReport;
import org.u2sa.messages.frame.Geodetic;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.testkit.ServiceKit;

/** One number that is finite, but absurd, in each field in turn, of a sensor that is sound. */
class AbsurdNumbersTest {
  private static final Geodetic HOME = new Geodetic(-81.0, 29.0, 5.0);
  private static final double SPEED_MPS = 2.0;

  private ServiceKit kit;

  private void start(String estimator) {
    kit = new ServiceKit();
    kit.start(
        context ->
            switch (estimator) {
              case "fusing" -> new FusingStateEstimator(context);
              case "complementary" -> new ComplementaryStateEstimator(context);
              default -> new PassThroughStateEstimator(context);
            });
  }

  private Geodetic place() {
    return HOME.fromEnu(Point.of(SPEED_MPS * kit.nowS(), 0.0, 0.0));
  }

  private void sense(StateInformation measured) {
    kit.publish(Channels.SENSED_STATE, measured);
  }

  private StateInformation fix() {
    return new StateInformation()
        .sensorName("GPS")
        .x(place().longitudeDeg())
        .y(place().latitudeDeg())
        .z(5.0)
        .xSigma(0.5)
        .ySigma(0.5)
        .xDot(SPEED_MPS)
        .yDot(0.0)
        .psi(Math.PI / 2.0)
        .psiSigma(0.02);
  }

  private static InertialMeasurement imu() {
    InertialMeasurement imu = new InertialMeasurement();
    imu.rollRate(0.0).pitchRate(0.0).yawRate(0.0);
    imu.specificForceX(0.0).specificForceY(0.0).specificForceZ(-9.79);
    imu.sensorName("IMU");
    return imu;
  }

  private void drive(double seconds) {
    for (int i = 1; i <= seconds * 20; i++) {
      kit.advance(0.05);
      sense(imu());
      if (i % 4 == 0) {
        sense(fix());
      }
    }
  }

  private List<Consumer<Double>> fields() {
    List<Consumer<Double>> fields = new ArrayList<>();
    for (StateField field : StateField.values()) {
      boolean isOfVehicle = field.ordinal() >= StateField.FLUID_X_DOT.ordinal();
      fields.add(value -> sense(fix().number(field, value)));
      if (!isOfVehicle) {
        fields.add(
            value ->
                sense(
                    new StateInformation()
                        .sensorName("Encoders")
                        .referenceFrame(ReferenceFrame.BODY_FLU)
                        .xDot(SPEED_MPS)
                        .number(field, value)));
      }
    }
    fields.add(value -> sense(imu().rollRate(value)));
    fields.add(value -> sense(imu().yawRate(value)));
    fields.add(value -> sense(imu().specificForceX(value)));
    fields.add(value -> sense(imu().specificForceZ(value)));
    fields.add(value -> sense(imu().angularRateSigma(Math.abs(value))));
    fields.add(value -> sense(imu().specificForceSigma(Math.abs(value))));
    return fields;
  }

  @ParameterizedTest
  @ValueSource(strings = {"fusing", "complementary", "passing on"})
  void callback_absurdNumber_estimateIsGoodAgainSoonAfter(String estimator) {
    start(estimator);
    drive(10.0);
    int heard = 0;
    for (double absurd : new double[] {1e200, 1e15, -1e15, 2e9, 9e8}) {
      int number = 0;
      for (Consumer<Double> field : fields()) {
        heard += isHeard(field, absurd) ? 1 : 0;
        drive(1.0);
        requireSound("field " + number++ + ": " + absurd);
      }
    }
    assertThat(heard).isGreaterThan(100);
    assertThat(kit.latest(Channels.HEALTH).flatMap(HealthReport::lastError))
        .hasValueSatisfying(said -> assertThat(said).contains("outside ±"));
    kit.close();
  }

  /** Messages themselves refuse numbers beyond what their fields can mean. */
  private static boolean isHeard(Consumer<Double> field, double value) {
    try {
      field.accept(value);
      return true;
    } catch (IllegalArgumentException e) {
      return false;
    }
  }

  /** What is possible, if only just, may mislead for a while. */
  @ParameterizedTest
  @ValueSource(strings = {"fusing", "complementary", "passing on"})
  void callback_wildNumber_estimateIsGoodAgainInTime(String estimator) {
    start(estimator);
    drive(10.0);
    int number = 0;
    for (Consumer<Double> field : fields()) {
      field.accept(900.0);
      drive(40.0);
      requireSound("field " + number++);
    }
    kit.close();
  }

  private void requireSound(String why) {
    StateInformation state = kit.latest(Channels.STATE).orElseThrow();
    for (StateField field : StateField.values()) {
      OptionalDouble value = state.number(field);
      assertThat(Math.abs(value.orElse(0.0))).as("%s, %s", why, field).isLessThan(1e4);
    }
    assertThat(state.timestamp()).hasValue(kit.clock().micros());
    assertThat(state.x()).as(why).isPresent();
    Geodetic said = new Geodetic(state.x().orElseThrow(), state.y().orElseThrow(), 5.0);
    assertThat(place().distanceM(said)).as(why).isLessThan(1.0);
  }
}
