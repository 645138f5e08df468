package org.u2sa.control;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.messages.NavigationPoint;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.command.PercentageCommand;
import org.u2sa.messages.frame.Point;
import org.u2sa.service.ServiceContext;
import org.u2sa.service.handover.HandOver;
import org.u2sa.testkit.ServiceKit;

class ControlSystemTest {
  private final ServiceKit kit = new ServiceKit();
  private RecordingControl control = kit.start(RecordingControl::new);

  @AfterEach
  void close() {
    kit.close();
  }

  @Test
  void callback_state_controlsOnceWithTimeStep() {
    kit.publish(Channels.STATE, state());
    kit.advance(0.02);
    kit.publish(Channels.STATE, state());

    assertThat(control.steps).containsExactly(0.0, 0.02);
  }

  @Test
  void callback_stateThatIsNotNewer_isLeftOut() {
    kit.advance(1.0);
    kit.publish(Channels.STATE, state());
    StateInformation older = state();
    older.timestamp(900_000L);
    kit.publish(Channels.STATE, older);
    kit.publish(Channels.STATE, state()); // of the same time

    assertThat(control.steps).hasSize(1);
  }

  @Test
  void callback_stateAfterGap_stepIsZero() {
    kit.publish(Channels.STATE, state());
    kit.advance(5.0);
    kit.publish(Channels.STATE, state());

    assertThat(control.steps).containsExactly(0.0, 0.0);
  }

  @Test
  void callback_statesRarerThanCommandsExpire_isReportedOnce() {
    for (int i = 0; i < 4; i++) {
      kit.publish(Channels.STATE, state());
      kit.advance(0.6);
    }

    assertThat(kit.log(control.getServiceName()).stream().filter(l -> l.contains("COMMAND EXPIRY")))
        .hasSize(1)
        .allMatch(line -> line.contains("commands expire 0.50 s after a state"));
  }

  @Test
  void callback_freshNavigationPoint_isHandedOn() {
    NavigationPoint point = NavigationPoint.at(Point.of(1.0, 2.0, 3.0));
    kit.publish(Channels.NAVIGATION, point);
    kit.advance(0.5);
    kit.publish(Channels.STATE, state());

    assertThat(control.points).containsExactly(Optional.of(point));
  }

  @Test
  void callback_navigationPointOlderThanStaleAfter_countsAsAbsent() {
    kit.publish(Channels.NAVIGATION, NavigationPoint.at(Point.of(1.0, 2.0, 3.0)));
    kit.advance(1.01);
    kit.publish(Channels.STATE, state());

    assertThat(control.points).containsExactly(Optional.empty());
  }

  @Test
  void callback_navigationPointOfAStateNotSeen_theOneBeforeIsKept() {
    kit.publish(Channels.STATE, state());
    NavigationPoint seen = NavigationPoint.at(Point.of(1.0, 2.0, 3.0));
    kit.publish(Channels.NAVIGATION, seen);
    kit.advance(0.02);
    kit.publish(Channels.STATE, state());
    NavigationPoint ahead = NavigationPoint.at(Point.of(4.0, 5.0, 6.0));
    ahead.timestamp(30_000L); // its state was replaced in the inbox by the next one
    kit.publish(Channels.NAVIGATION, ahead);
    kit.advance(0.02);
    kit.publish(Channels.STATE, state());

    assertThat(control.points)
        .containsExactly(Optional.empty(), Optional.of(seen), Optional.of(seen));
  }

  @Test
  void callback_navigationPointOfOtherSubsystem_isNotTheVehicles() {
    kit.publish(Channels.NAVIGATION, NavigationPoint.at(Point.of(1.0, 2.0, 3.0)).subsystem("ARM"));
    kit.publish(Channels.STATE, state());

    assertThat(control.points).containsExactly(Optional.empty());
  }

  @Test
  void nedOf_pointOfEarlierState_isTurnedByThatStatesAttitude() {
    kit.publish(Channels.STATE, state().psi(Math.PI / 2.0));
    kit.publish(Channels.NAVIGATION, NavigationPoint.at(Point.of(10.0, 2.0, 3.0)));
    kit.advance(0.02);
    kit.publish(Channels.STATE, state().psi(0.0));

    Point ned = control.ned.orElseThrow();
    assertThat(ned.x()).isCloseTo(2.0, within(1.0e-9)); // heading east, so left is north
    assertThat(ned.y()).isCloseTo(10.0, within(1.0e-9));
    assertThat(ned.z()).isCloseTo(3.0, within(1.0e-9));
  }

  @Test
  void command_outsideRange_isBoundedAndExpires() {
    control.percentage = 250.0;
    kit.publish(Channels.STATE, state());

    PercentageCommand command = (PercentageCommand) kit.latest(Channels.ACTUATION).orElseThrow();
    assertThat(command.actuatorName()).isEqualTo("THROTTLE");
    assertThat(command.percentage()).isEqualTo(100.0);
    assertThat(command.expiry()).hasValue(0.5);
  }

  @Test
  void kill_actuatorsAreLeftNeutral() {
    control.percentage = 80.0;
    kit.publish(Channels.STATE, state());
    control.kill();

    assertThat(kit.percent("THROTTLE")).isEqualTo(-5.0);
  }

  @Test
  void callback_navigationPointWithoutAnyState_isObeyedIfControlNeedsNone() {
    NavigationPoint point = NavigationPoint.at(Point.of(1.0, 2.0, 0.0));
    kit.publish(Channels.NAVIGATION, point);
    assertThat(control.points).as("needs a state").isEmpty();

    control.obeysWithoutState = true;
    kit.advance(0.1);
    NavigationPoint next = NavigationPoint.at(Point.of(1.0, 2.0, 0.0));
    kit.publish(Channels.NAVIGATION, next);
    kit.advance(0.1);
    NavigationPoint last = NavigationPoint.at(Point.of(0.9, 2.0, 0.0));
    kit.publish(Channels.NAVIGATION, last);

    assertThat(control.points).containsExactly(Optional.of(next), Optional.of(last));
    assertThat(control.steps).containsExactly(0.0, 0.1);
    assertThat(control.ned).contains(Point.of(0.9, -2.0, 0.0)); // y of BODY is to the left
    assertThat(control.isStateless()).isTrue();
  }

  @Test
  void callback_navigationPointNotOfTheVehicleOrOldWithoutState_isNotObeyed() {
    control.obeysWithoutState = true;
    kit.advance(5.0);
    kit.publish(Channels.NAVIGATION, NavigationPoint.at(Point.ORIGIN).subsystem("ARM"));
    NavigationPoint old = NavigationPoint.at(Point.ORIGIN);
    old.timestamp(3_900_000L);
    kit.publish(Channels.NAVIGATION, old);

    assertThat(control.points).isEmpty();
  }

  @Test
  void callback_navigationPointWhileStatesCome_waitsForTheState() {
    control.obeysWithoutState = true;
    kit.publish(Channels.STATE, state());
    kit.advance(0.9);
    kit.publish(Channels.NAVIGATION, NavigationPoint.at(Point.ORIGIN));
    assertThat(control.points).hasSize(1);

    kit.advance(0.2);
    kit.publish(Channels.NAVIGATION, NavigationPoint.at(Point.ORIGIN));
    assertThat(control.points).hasSize(2);
  }

  /** What was computed from an origin lies elsewhere by the state: it would drive off. */
  @Test
  void callback_stateAgain_forgetsNavigationPointsWithoutState() {
    control.obeysWithoutState = true;
    kit.publish(Channels.NAVIGATION, NavigationPoint.at(Point.of(5.0, 0.0, 0.0)));
    kit.advance(0.1);
    kit.publish(Channels.STATE, state());

    assertThat(control.points.get(1)).isEmpty();
    assertThat(control.steps).containsExactly(0.0, 0.0);
    assertThat(control.isStateless()).isFalse();
  }

  @Test
  void handOver_withoutState_leavesOriginsBehind() {
    control.obeysWithoutState = true;
    kit.publish(Channels.NAVIGATION, NavigationPoint.at(Point.of(5.0, 0.0, 0.0)));
    HandOver memory = new HandOver("RecordingControl");
    control.handOver(memory);

    assertThat(control.isStateless()).isTrue();
    assertThat(memory.messages("STATES", StateInformation.class)).isEmpty();
    assertThat(memory.messages("POINTS", NavigationPoint.class)).isEmpty();
  }

  @Test
  void takeOver_statesOfTheOneBefore_navigationPointWaitsForTheNextState() {
    kit.publish(Channels.STATE, state());
    control = kit.swap(control, RecordingControl::new);
    control.obeysWithoutState = true;
    kit.publish(Channels.NAVIGATION, NavigationPoint.at(Point.of(5.0, 0.0, 0.0)));

    assertThat(control.points).isEmpty();
  }

  @Test
  void release_whileBlendingFromAnotherLaw_isNeutralAtOnce() {
    swapFromAnotherLaw();
    control.release();

    PercentageCommand last = (PercentageCommand) kit.latest(Channels.ACTUATION).orElseThrow();
    assertThat(last.percentage()).isEqualTo(-5.0);
  }

  @Test
  void takeOver_swapFromAnotherLaw_blendsFromItsCommands() {
    swapFromAnotherLaw();

    PercentageCommand last = (PercentageCommand) kit.latest(Channels.ACTUATION).orElseThrow();
    assertThat(last.percentage()).isEqualTo(80.0);
  }

  /** After a restart, actuators have been neutral: what was commanded before is out of date. */
  @Test
  void takeOver_restart_continuesFromNoCommandOrPoint() {
    commandByAnotherLaw();
    kit.publish(Channels.NAVIGATION, NavigationPoint.at(Point.of(5.0, 0.0, 0.0)));
    control.save();
    control = kit.restart(control, RecordingControl::new);
    kit.publish(Channels.STATE, state());

    PercentageCommand last = (PercentageCommand) kit.latest(Channels.ACTUATION).orElseThrow();
    assertThat(last.percentage()).isZero();
    assertThat(control.points).containsExactly(Optional.empty());
  }

  private void swapFromAnotherLaw() {
    commandByAnotherLaw();
    control = kit.swap(control, RecordingControl::new);
    kit.publish(Channels.STATE, state());
  }

  private void commandByAnotherLaw() {
    control.shutDown();
    control = kit.start(AnotherControl::new);
    control.percentage = 80.0;
    kit.publish(Channels.STATE, state());
    kit.advance(0.1);
  }

  private static StateInformation state() {
    return new StateInformation().x(8.0).y(50.0).z(100.0).phi(0.0).theta(0.0).psi(0.0);
  }

  /** Remembers what it is asked. */
  private static class RecordingControl extends ControlSystem {
    private final List<Double> steps = new ArrayList<>();
    private final List<Optional<NavigationPoint>> points = new ArrayList<>();
    private Optional<Point> ned = Optional.empty();
    private double percentage;
    private boolean obeysWithoutState;

    RecordingControl(ServiceContext context) {
      super(context, "RecordingControl");
    }

    void save() {
      remember();
    }

    @Override
    protected boolean obeysWithoutState() {
      return obeysWithoutState;
    }

    @Override
    protected void control(StateInformation state, Optional<NavigationPoint> point) {
      steps.add(stepS());
      points.add(point);
      ned = point.flatMap(this::nedOf);
      command("THROTTLE", percentage);
    }

    @Override
    protected Map<String, Double> neutral() {
      return Map.of("THROTTLE", -5.0);
    }
  }

  private static final class AnotherControl extends RecordingControl {
    AnotherControl(ServiceContext context) {
      super(context);
    }
  }
}
