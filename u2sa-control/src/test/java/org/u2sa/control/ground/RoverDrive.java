package org.u2sa.control.ground;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.function.BooleanSupplier;
import java.util.function.Function;
import org.u2sa.control.ControlSystem;
import org.u2sa.estimation.PassThroughStateEstimator;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.command.AngleCommand;
import org.u2sa.messages.command.PercentageCommand;
import org.u2sa.messages.contract.ActuatorAnnouncement;
import org.u2sa.messages.frame.Geodetic;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.safety.ArmingState;
import org.u2sa.mission.MissionManager;
import org.u2sa.planning.PathPlanner;
import org.u2sa.service.ServiceContext;
import org.u2sa.testkit.ServiceKit;

/**
 * State Estimator, Mission Manager, Path Planner and a control in lockstep with a {@link
 * KinematicRover}.
 */
final class RoverDrive implements AutoCloseable {
  /** Angle at +100 % of a steering that takes angles [rad]. */
  static final double FULL_ANGLE_RAD = Math.toRadians(28.0);

  private static final double STEP_S = 0.05;

  /** Where the vehicle truly was, and how many goals it had completed. */
  record Sample(double timeS, double north, double east, double speed, int goalsDone) {}

  final ServiceKit kit = new ServiceKit();
  final KinematicRover rover;
  final List<Sample> track = new ArrayList<>();
  final MissionManager missions;
  private final Path mission;
  ControlSystem control;
  boolean measures = true; // false: no position

  RoverDrive(
      KinematicRover rover,
      Path mission,
      Map<String, Object> planner,
      Function<ServiceContext, ? extends ControlSystem> constructor,
      Map<String, Object> variables) {
    this.rover = rover;
    kit.start(PassThroughStateEstimator::new);
    this.mission = mission;
    missions = startMissions();
    kit.withoutVariables();
    planner.forEach(kit::with);
    kit.start(PathPlanner::new);
    kit.withoutVariables();
    variables.forEach(kit::with);
    control = kit.start(constructor);
  }

  /** A mission over corners, north and east [m] of the origin. */
  static Path mission(Path directory, double thresholdM, double[]... corners) {
    StringBuilder goals = new StringBuilder("<mission>");
    for (double[] corner : corners) {
      Geodetic place = KinematicRover.ORIGIN.fromNed(Point.of(corner[0], corner[1], 0.0));
      goals.append(
          String.format(
              Locale.ROOT,
              "<waypoint><x>%.9f</x><y>%.9f</y><horizontalThreshold>%s</horizontalThreshold></waypoint>",
              place.longitudeDeg(),
              place.latitudeDeg(),
              thresholdM));
    }
    try {
      return Files.writeString(directory.resolve("mission.xml"), goals + "</mission>");
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  /** Puts another control in the place of the one that drives. */
  void swap(Function<ServiceContext, ? extends ControlSystem> constructor) {
    control = kit.swap(control, constructor);
  }

  MissionManager startMissions() {
    kit.withoutVariables();
    return kit.with("MISSION", mission.toString())
        .with("DEFAULT THRESHOLD", 0.5)
        .start(MissionManager::new);
  }

  void restart(Function<ServiceContext, ? extends ControlSystem> constructor) {
    control = kit.restart(control, constructor);
  }

  /** Says what is left of an actuator [%]. */
  void announce(String actuator, double available) {
    kit.publish(Channels.ACTUATORS, announcement(actuator).available(available));
  }

  /** Says whether a radio drives the motors. */
  void withhold(boolean withheld) {
    for (String motor : List.of("LEFT MOTOR", "RIGHT MOTOR")) {
      kit.publish(Channels.ACTUATORS, announcement(motor).withheld(withheld));
    }
  }

  private static ActuatorAnnouncement announcement(String actuator) {
    return new ActuatorAnnouncement().actuatorName(actuator).minimum(-100.0).maximum(100.0);
  }

  /** Drives until the condition holds, or for that long; answers whether it held. */
  boolean until(BooleanSupplier done, double limitS) {
    for (double end = kit.nowS() + limitS; kit.nowS() < end && !done.getAsBoolean(); ) {
      if (measures) {
        kit.publish(Channels.SENSED_STATE, rover.measured());
      } else {
        kit.publish(Channels.SENSED_STATE, new StateInformation().psi(rover.heading));
      }
      rover.step(STEP_S, this::percent);
      track.add(new Sample(kit.nowS(), rover.north, rover.east, rover.speed, goalsDone()));
      kit.advance(STEP_S);
    }
    return done.getAsBoolean();
  }

  /** Nothing runs for a time; its motors stop. */
  void freeze(double seconds) {
    for (double end = kit.nowS() + seconds; kit.nowS() < end; ) {
      rover.step(STEP_S, motor -> 0.0);
      kit.advance(STEP_S);
    }
  }

  /** Runs for a time in which the motors do not obey. */
  void disarmed(double seconds) {
    kit.publish(Channels.ARMING_STATE, new ArmingState().armed(false));
    for (double end = kit.nowS() + seconds; kit.nowS() < end; ) {
      kit.publish(Channels.SENSED_STATE, rover.measured());
      rover.step(STEP_S, motor -> 0.0);
      kit.advance(STEP_S);
    }
    kit.publish(Channels.ARMING_STATE, new ArmingState().armed(true));
  }

  double percent(String actuator) {
    return kit.published(Channels.ACTUATION).stream()
        .filter(command -> command.actuatorName().equals(actuator))
        .mapToDouble(
            command ->
                command instanceof AngleCommand angle // as an actuator of that FULL ANGLE
                    ? 100.0 * angle.angle() / FULL_ANGLE_RAD
                    : ((PercentageCommand) command).percentage())
        .reduce((first, second) -> second)
        .orElse(0.0);
  }

  int goalsDone() {
    return kit.published(Channels.GOAL_REPORTS).size();
  }

  boolean isMissionOver() {
    return kit.latest(Channels.GOALS).orElseThrow().goals().isEmpty();
  }

  /** How near the vehicle truly came to a place [m]. */
  double missM(double[] corner) {
    return track.stream()
        .mapToDouble(s -> Math.hypot(s.north() - corner[0], s.east() - corner[1]))
        .min()
        .orElseThrow();
  }

  /** Of the legs between corners, where farther than the margin from their beginnings [m]. */
  double crossTrackRmsM(double marginM, double[]... corners) {
    double sum = 0.0;
    int count = 0;
    for (Sample s : track) {
      if (s.goalsDone() >= 1 && s.goalsDone() < corners.length) {
        double[] from = corners[s.goalsDone() - 1];
        double[] to = corners[s.goalsDone()];
        double bearing = Math.atan2(to[1] - from[1], to[0] - from[0]);
        double north = s.north() - from[0];
        double east = s.east() - from[1];
        if (north * Math.cos(bearing) + east * Math.sin(bearing) > marginM) {
          sum += Math.pow(east * Math.cos(bearing) - north * Math.sin(bearing), 2);
          count++;
        }
      }
    }
    return Math.sqrt(sum / count);
  }

  @Override
  public void close() {
    kit.close();
  }
}
