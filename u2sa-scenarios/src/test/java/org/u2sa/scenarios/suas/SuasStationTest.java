package org.u2sa.scenarios.suas;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.messages.frame.Attitude;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.goal.GoalList;
import org.u2sa.messages.goal.Waypoint;
import org.u2sa.messages.mission.MissionAction;
import org.u2sa.messages.mission.MissionOrder;
import org.u2sa.messages.mission.MissionOrderResult;
import org.u2sa.messages.safety.ManualState;
import org.u2sa.sim.vehicle.VehicleTruth;
import org.u2sa.testkit.ServiceKit;

/** The ground station of the demo, and the drop as the judge reckons it. */
class SuasStationTest {
  private final ServiceKit kit = new ServiceKit();

  @AfterEach
  void end() {
    kit.close();
  }

  private SuasStation station(double downFromS, double downUntilS) {
    SuasStation.Script script =
        new SuasStation.Script(100_325.0, Optional.of("<mission/>"), "drop", downFromS, downUntilS);
    return kit.start(context -> new SuasStation(context, script));
  }

  @Test
  void step_stationDownForAWhile_sendsNothingThenGoesOn() {
    SuasStation station = station(3.5, 7.5);
    kit.advance(3.2);
    assertThat(kit.published(Channels.OPERATOR)).hasSizeBetween(3, 4);
    assertThat(kit.latest(Channels.GROUND_PRESSURE).orElseThrow().pressure()).isEqualTo(100_325.0);
    int before = kit.published(Channels.OPERATOR).size();
    kit.advance(4.0);
    assertThat(kit.published(Channels.OPERATOR)).hasSize(before);
    assertThat(station.isUp()).isFalse();
    kit.advance(2.0);
    assertThat(kit.published(Channels.OPERATOR)).hasSizeGreaterThan(before);
    assertThat(station.isUp()).isTrue();
  }

  @Test
  void step_missionManagerDoesNotAnswer_ordersAgainUntilItIsAcknowledged() {
    SuasStation station = station(1e9, 1e9);
    kit.publish(
        Channels.GOALS,
        new GoalList().goals(List.of(new Waypoint().horizontalThreshold(1.0).uid("1"))));
    kit.advance(8.0);
    List<MissionOrder> orders =
        kit.published(Channels.MISSION).stream()
            .filter(MissionOrder.class::isInstance)
            .map(MissionOrder.class::cast)
            .toList();
    assertThat(orders).hasSizeBetween(2, 4);
    kit.publish(
        Channels.MISSION,
        new MissionOrderResult()
            .requestId(orders.get(0).requestId())
            .serviceName("MissionManager")
            .accepted(true)
            .outcome("inserted"));
    kit.advance(10.0);
    assertThat(station.changes()).isEqualTo(1);
    assertThat(
            kit.published(Channels.MISSION).stream().filter(MissionOrder.class::isInstance).count())
        .as("no further order")
        .isEqualTo(orders.size());
  }

  @Test
  void step_pilotGaveBack_resumesTheMissionOnceAcknowledged() {
    station(1e9, 1e9);
    kit.publish(Channels.MANUAL_STATE, new ManualState().active(true).takeovers(1));
    kit.advance(5.0);
    assertThat(kit.published(Channels.MISSION)).isEmpty();
    kit.publish(Channels.MANUAL_STATE, new ManualState().active(false).takeovers(1));
    kit.advance(1.5);
    MissionOrder order = (MissionOrder) kit.latest(Channels.MISSION).orElseThrow();
    assertThat(order.action()).isEqualTo(MissionAction.RESUME);
    kit.publish(
        Channels.MISSION,
        new MissionOrderResult()
            .requestId(order.requestId())
            .serviceName("MissionManager")
            .accepted(true)
            .outcome("resumed"));
    kit.forget();
    kit.advance(10.0);

    assertThat(kit.published(Channels.MISSION)).isEmpty();
  }

  @Test
  void landing_fromRestInWind_isCarriedDownwind() {
    SuasField field = SuasFieldGenerator.field(1, 5.0);
    VehicleTruth hovers =
        new VehicleTruth(
            0.0,
            Point.of(10.0, 20.0, 40.0),
            new Attitude(0.0, 0.0, 0.0),
            Point.ORIGIN,
            Point.ORIGIN,
            Point.ORIGIN);
    Point landing = DroppedBottle.landing(field, hovers);
    double east = landing.x() - 10.0;
    double north = landing.y() - 20.0;
    double downwindRad = Math.atan2(east, north) - field.windFromRad() - Math.PI;
    assertThat(Math.IEEEremainder(downwindRad, 2.0 * Math.PI)).isCloseTo(0.0, within(1e-6));
    assertThat(Math.hypot(east, north)).isBetween(2.0, 8.0);
  }
}
