package org.u2sa.scenarios.vrx;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.stream.Collectors;
import org.u2sa.messages.ObjectDescription;
import org.u2sa.messages.frame.Geodetic;
import org.u2sa.messages.frame.Point;
import org.u2sa.sim.atmosphere.Wind;
import org.u2sa.sim.world.CurrentField;
import org.u2sa.sim.world.LocalPlane;
import org.u2sa.sim.world.Water;
import org.u2sa.sim.world.Waves;
import org.u2sa.sim.world.World;
import org.u2sa.trials.run.SimulatedWorld;

/**
 * A task as described by a VRX world.
 *
 * @param file the world file
 * @param origin origin of the coordinates east, north, up
 * @param wind wind of the world
 * @param sea waves of the world
 * @param times durations of the task
 * @param goals positions with headings, in the order of the file
 * @param gates gates in the order of the course
 * @param buoys markers and obstacles, in LOCAL_ENU
 * @param wildlife animals of that task
 * @param docking dock and light buoy of that task
 */
record VrxWorld(
    Path file,
    VrxTask task,
    Geodetic origin,
    Breeze wind,
    Sea sea,
    Times times,
    List<Goal> goals,
    List<Gate> gates,
    List<ObjectDescription> buoys,
    Wildlife wildlife,
    Docking docking) {

  /** Where the WAM-V is spawned: east, north [m]; yaw 1 rad, by VRX's competition launch files. */
  static final Point START = Point.of(-532.0, 162.0, 0.0);

  static final double START_HEADING_RAD = headingOf(1.0);

  private static final double VERTICAL_SHARE = 0.5096; // σ_w / σ_u below 10 ft, MIL-F-8785C
  private static final double SPREAD_RAD = 0.33; // of wave components at −0.4, 0 and 0.4 rad

  /**
   * Wind of libUSVWind: v̇ = (−v + g N/√dt)/τ about the mean, along one direction.
   *
   * @param meanMps mean speed [m/s]
   * @param fromRad direction it blows from, clockwise from north [rad]
   * @param gain g [m/s √s]
   * @param timeS τ [s]
   */
  record Breeze(double meanMps, double fromRad, double gain, double timeS) {
    /** Standard deviation of the speed: g / √(2τ) [m/s]. */
    double sigmaMps() {
      return gain / Math.sqrt(2.0 * timeS);
    }
  }

  /**
   * Wave field.
   *
   * @param heightM significant height [m]
   * @param periodS of the peak [s]
   * @param towardsRad direction of travel, clockwise from north [rad]
   */
  record Sea(double heightM, double periodS, double towardsRad) {}

  /**
   * Durations of the states of a task [s].
   *
   * @param readyS vehicle released, goal known, not scored
   * @param runningS scored
   */
  record Times(double readyS, double runningS) {}

  /**
   * A pose to assume.
   *
   * @param headingRad clockwise from north [rad]
   */
  record Goal(double longitudeDeg, double latitudeDeg, double headingRad) {}

  /**
   * Two markers to pass between: east, north, up [m]. VRX's left marker is passed to starboard
   * (NavigationScoringPlugin.cc: the way is up × (left − right)).
   */
  record Gate(Point left, Point right) {
    Point centre() {
      return left.plus(right).times(0.5);
    }

    double widthM() {
      return left.minus(right).distance();
    }

    /** Direction in which to cross the gate, clockwise from north [rad]. */
    double headingRad() {
      Point across = left.minus(right);
      return headingOf(Math.atan2(across.y(), across.x()) + 0.5 * Math.PI);
    }
  }

  /** Clockwise from north, of an angle anticlockwise from east [rad]. */
  static double headingOf(double yawRad) {
    return Math.IEEEremainder(0.5 * Math.PI - yawRad, 2.0 * Math.PI);
  }

  /** Obstacles and animals, relative to the start instead of the origin, for maps of a run. */
  List<ObjectDescription> objectsFromStart() {
    List<ObjectDescription> moved = new ArrayList<>();
    for (ObjectDescription object : SimulatedWorld.surroundings(solid(), 300.0).objects()) {
      moved.add(object.movedTo(object.center().minus(START)));
    }
    return moved;
  }

  /** Obstacles that can be touched. */
  World solid() {
    List<ObjectDescription> all = new ArrayList<>(buoys);
    all.addAll(docking.objects());
    return World.at(origin)
        .with(all)
        .withMovers(
            wildlife.animals().stream().map(Wildlife.Animal::mover).collect(Collectors.toList()));
  }

  LocalPlane plane() {
    return new LocalPlane(origin);
  }

  /**
   * The simulated world. Gusts have the strength given in the file and the spectrum of MIL-F-8785C
   * along and across the vehicle; waves have a Pierson-Moskowitz spectrum, as in VRX, with more
   * than its three components.
   *
   * @param seed of gusts and waves
   */
  World simulated(long seed) {
    World wet =
        solid()
            .with(
                new Water(
                    0.0,
                    CurrentField.uniform(0.0, 0.0),
                    sea.heightM() > 0.0 ? Optional.of(waves(seed)) : Optional.empty()));
    return wet.with(
        Wind.constant(wind.fromRad(), wind.meanMps())
            .withGusts(VERTICAL_SHARE * wind.sigmaMps(), seed));
  }

  private Waves waves(long seed) {
    return Waves.of(
        Waves.Spectrum.PIERSON_MOSKOWITZ,
        sea.heightM(),
        sea.periodS(),
        sea.towardsRad(),
        SPREAD_RAD,
        seed);
  }
}
