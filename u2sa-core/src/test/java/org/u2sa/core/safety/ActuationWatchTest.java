package org.u2sa.core.safety;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.command.PercentageCommand;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.messages.safety.FailsafeAction;
import org.u2sa.service.Actuator;
import org.u2sa.service.ServiceContext;

/** A vehicle whose actuators do not obey its control, beside a SafetyManager. */
class ActuationWatchTest extends WatchedVehicle {
  private static final double HOUR_S = 3600.0;

  /** Takes what it is commanded. */
  private static final class Motor extends Actuator {
    Motor(ServiceContext context) {
      super(context, "Motor");
    }

    @Override
    protected void actuate(double percentage) {
      assertThat(percentage).isBetween(-100.0, 100.0);
    }

    @Override
    protected void neutral() {
      assertThat(actuatorName()).isEqualTo("MOTOR");
    }
  }

  private void armed() {
    start();
    kit.withoutVariables().with("ACTUATOR NAME", "MOTOR");
    kit.start(Motor::new);
    live(1.0);
    assertThat(arm(true).armed()).isTrue();
  }

  /** States, and a control whose clock is ahead. */
  private void drive(double seconds, double aheadS) {
    for (double t = 0.0; t < seconds - 1e-9; t += 0.1) {
      PercentageCommand command = PercentageCommand.of("MOTOR", 20.0);
      command.timestamp(kit.clock().micros() + Math.round(aheadS * 1e6));
      kit.send(Channels.ACTUATION, command);
      live(0.1);
    }
  }

  @Test
  void step_controlStampsTheFuture_failsafeSaysThatActuatorsRefuseAll() {
    armed();
    drive(3.0, 0.0);
    assertThat(failsafe().action()).isEqualTo(FailsafeAction.CONTINUE);

    drive(4.0, HOUR_S);

    assertThat(failsafe().action()).isEqualTo(FailsafeAction.HOLD);
    assertThat(failsafe().causes())
        .singleElement()
        .asString()
        .startsWith("actuation refused: Motor refuses all commands, ");
  }

  @Test
  void step_controlIsObeyedAgain_failsafeEndsAsTheOthersDo() {
    armed();
    drive(4.0, HOUR_S);

    drive(5.0, 0.0);

    assertThat(failsafe().action()).isEqualTo(FailsafeAction.CONTINUE);
  }

  @Test
  void step_refusedForLessThanRefusalTime_isNoCause() {
    armed();
    drive(1.5, HOUR_S);
    drive(2.0, 0.0);

    assertThat(kit.published(Channels.FAILSAFE))
        .allMatch(state -> state.action() == FailsafeAction.CONTINUE);
  }

  @Test
  void step_refusedBeforeItIsArmed_isNoCause() {
    start();
    kit.withoutVariables().with("REQUIRES ARMING", true).with("ACTUATOR NAME", "MOTOR");
    kit.start(Motor::new);
    drive(5.0, 0.0); // control runs already, and nothing obeys it
    assertThat(arm(true).armed()).isTrue();
    drive(5.0, 0.0);

    assertThat(kit.published(Channels.FAILSAFE))
        .allMatch(state -> state.action() == FailsafeAction.CONTINUE);
  }

  @Test
  void step_statesStampedAheadThatStop_arePositionLossInTime() {
    kit.with("ON POSITION LOSS", "HOLD");
    armed();
    StateInformation ahead = new StateInformation().referenceFrame(ReferenceFrame.LOCAL_ENU);
    ahead.x(0.0).y(0.0).timestamp(kit.clock().micros() + 3_600_000_000L);
    kit.publish(Channels.STATE, ahead);

    kit.advance(3.0);

    assertThat(failsafe().action()).isEqualTo(FailsafeAction.HOLD);
    assertThat(failsafe().causes()).anyMatch(cause -> cause.startsWith("position: state is "));
  }
}
