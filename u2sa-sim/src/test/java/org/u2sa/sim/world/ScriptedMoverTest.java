package org.u2sa.sim.world;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.u2sa.messages.ObjectDescription;
import org.u2sa.messages.frame.Geodetic;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.messages.shape.Box;
import org.u2sa.messages.shape.Cylinder;

class ScriptedMoverTest {
  private static final World PLAIN = World.at(new Geodetic(9.0, 54.0, 0.0));

  private static ObjectDescription walker() {
    Cylinder body = new Cylinder();
    body.radius(0.3).height(1.8);
    body.uid("walker").referenceFrame(ReferenceFrame.LOCAL_ENU);
    return body.x(10.0).y(0.0).z(0.9);
  }

  private static ScriptedMover mover(
      ObjectDescription object, ScriptedMover.End end, boolean floats) {
    List<ScriptedMover.Waypoint> way =
        List.of(
            new ScriptedMover.Waypoint(Point.of(10.0, 8.0, 0.9), 2.0, 1.0),
            new ScriptedMover.Waypoint(Point.of(16.0, 8.0, 0.9), 3.0, 0.0));
    return new ScriptedMover(object, PLAIN.plane(), way, end, 5.0, floats, false);
  }

  @Test
  void at_delayWayWaitAndEnd_followsTheScript() {
    ScriptedMover mover = mover(walker(), ScriptedMover.End.STOP, false);

    assertThat(mover.at(5.0).position()).isEqualTo(Point.of(10.0, 0.0, 0.9));
    assertThat(mover.at(4.0).velocity()).isEqualTo(Point.ORIGIN);
    assertThat(mover.at(7.0).position().y()).isCloseTo(4.0, within(1e-9));
    assertThat(mover.at(7.0).velocity().y()).isCloseTo(2.0, within(1e-9));
    assertThat(mover.at(9.5).velocity()).isEqualTo(Point.ORIGIN);
    assertThat(mover.at(11.0).position().x()).isCloseTo(13.0, within(1e-9));
    assertThat(mover.at(99.0).position()).isEqualTo(Point.of(16.0, 8.0, 0.9));
  }

  @Test
  void at_loopAndReturn_repeat() {
    ScriptedMover loop = mover(walker(), ScriptedMover.End.LOOP, false);
    ScriptedMover back = mover(walker(), ScriptedMover.End.RETURN, false);
    double period = 4.0 + 1.0 + 2.0 + 10.0 / 3.0;

    assertThat(loop.at(6.0 + 3.0 * period).position().distanceTo(loop.at(6.0).position()))
        .isLessThan(1e-9);
    assertThat(back.at(5.0 + 7.0 + 2.0 + 0.5).position())
        .isEqualTo(Point.of(10.0, 8.0, 0.9)); // waits there on its way back
    assertThat(back.at(5.0 + 7.0 + 2.0 + 1.0 + 2.0).position().y()).isCloseTo(4.0, within(1e-9));
    assertThat(back.at(5.0 + 14.0).position().y()).isCloseTo(0.0, within(1e-9));
  }

  @Test
  void when_moverOnTheRay_isHitWhereItIsThen() {
    World world = PLAIN.withMovers(List.of(mover(walker(), ScriptedMover.End.STOP, false)));
    Ray ray = Ray.of(Point.of(0.0, 4.0, 1.0), Math.PI / 2.0, 0.0);

    assertThat(world.when(0.0).distanceM(ray, 30.0)).isInfinite();
    assertThat(world.when(7.0).distanceM(ray, 30.0)).isCloseTo(9.7, within(1e-6));
    assertThat(
            world
                .when(7.0)
                .contacts(
                    Footprint.rectangle(0.5, 0.5, 0.5, 0.0, 1.0), Point.of(10.0, 4.0, 0.0), 0.0))
        .extracting(ObjectDescription::uid)
        .containsExactly("walker");
  }

  @Test
  void when_moverUnderWater_isHitBySonarRaysWithoutABed() {
    World sea =
        PLAIN
            .with(new Water(0.0, 0.0, 0.0))
            .withMovers(List.of(mover(walker().z(-3.0), ScriptedMover.End.STOP, false)));
    Ray ray = Ray.of(Point.of(0.0, 0.0, -3.0), Math.PI / 2.0, 0.0);

    assertThat(sea.when(0.0).distanceM(ray, 30.0)).isCloseTo(9.7, within(1e-6));
    assertThat(sea.distanceM(ray, 30.0)).isInfinite();
  }

  @Test
  void when_floatingBox_pointsAlongItsWayAndRidesTheWaves() {
    Waves waves = Waves.of(Waves.Spectrum.REGULAR, 1.0, 6.0, 0.3, 0.0, 9L);
    Water water = new Water(0.0, CurrentField.uniform(0.0, 0.0), Optional.of(waves));
    Box hull = new Box();
    hull.length(6.0).width(2.0).height(1.0);
    hull.uid("boat").referenceFrame(ReferenceFrame.LOCAL_NED);
    hull.x(0.0).y(10.0).z(0.0);
    ScriptedMover mover =
        new ScriptedMover(
            hull,
            PLAIN.plane(),
            List.of(new ScriptedMover.Waypoint(Point.of(8.0, 10.0, 0.0), 2.0, 0.0)),
            ScriptedMover.End.STOP,
            0.0,
            true,
            true);

    Box there = (Box) PLAIN.with(water).withMovers(List.of(mover)).when(3.0).obstacles().get(0);

    assertThat(there.center().x()).isCloseTo(10.0, within(1e-9));
    assertThat(there.center().y()).isCloseTo(6.0, within(1e-9));
    assertThat(there.psi()).isCloseTo(Math.PI / 2.0, within(1e-9));
    assertThat(there.z()).isCloseTo(water.waveM(10.0, 6.0, 3.0), within(1e-9));
  }

  @Test
  void constructor_pointObject_isRefusedWithWhatIsExpected() {
    ObjectDescription point = new ObjectDescription().uid("p");
    point.referenceFrame(ReferenceFrame.LOCAL_ENU);

    assertThatThrownBy(() -> mover(point, ScriptedMover.End.STOP, false))
        .isInstanceOf(IllegalArgumentException.class)
        .hasMessageContaining("expected a Box, Rectangle, Cylinder, Circle or Sphere");
  }
}
