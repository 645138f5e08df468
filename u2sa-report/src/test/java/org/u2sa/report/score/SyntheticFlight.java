package org.u2sa.report.score;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import net.sf.geographiclib.Geodesic;
import net.sf.geographiclib.GeodesicData;
import net.sf.geographiclib.GeodesicMask;
import org.u2sa.report.summary.RunReport;

/** Flights made by formula, so that their scores are known beforehand. */
public final class SyntheticFlight {

  public static final double LONGITUDE = -157.92;
  public static final double LATITUDE = 21.32;
  static final double SPEED_MPS = 50.0;

  private SyntheticFlight() {}

  /** The waypoint {@code eastM} and {@code northM} of the origin. */
  static RunPlan.Waypoint waypoint(String name, double eastM, double northM, double altitudeM) {
    GeodesicData at = at(eastM, northM);
    return new RunPlan.Waypoint(
        name, at.lon2, at.lat2, OptionalDouble.of(altitudeM), 100.0, OptionalDouble.of(50.0));
  }

  static TrackSample sample(double timeS, double eastM, double northM, double altitudeM, int leg) {
    return sample(timeS, eastM, northM, altitudeM, leg, false, "CRUISE");
  }

  static TrackSample sample(
      double timeS,
      double eastM,
      double northM,
      double altitudeM,
      int leg,
      boolean onGround,
      String phase) {
    GeodesicData at = at(eastM, northM);
    return new TrackSample(
        timeS,
        at.lon2,
        at.lat2,
        altitudeM,
        0.5,
        SPEED_MPS + 2.0,
        OptionalDouble.of(1.5),
        leg,
        phase,
        Optional.of(new TrackSample.Flight(0.1, 0.05, SPEED_MPS, onGround)));
  }

  private static GeodesicData at(double eastM, double northM) {
    return Geodesic.WGS84.Direct(
        LATITUDE,
        LONGITUDE,
        Math.toDegrees(Math.atan2(eastM, northM)),
        Math.hypot(eastM, northM),
        GeodesicMask.LATITUDE | GeodesicMask.LONGITUDE);
  }

  /**
   * Two waypoints on the meridian of the origin, 4 km apart, the first 2 km north of it, at 500 m.
   */
  public static RunPlan twoWaypoints() {
    return new RunPlan(
        Domain.AIR,
        Optional.empty(),
        List.of(waypoint("A", 0.0, 2000.0, 500.0), waypoint("B", 0.0, 6000.0, 500.0)));
  }

  /**
   * North along the meridian at 50 m/s, 10 samples a second, past both of {@link #twoWaypoints()},
   * off by so much.
   */
  static List<TrackSample> northward(double eastM, double tooHighM) {
    List<TrackSample> track = new ArrayList<>();
    for (int i = 0; i <= 1300; i++) {
      double north = i * 5.0;
      int leg = north < 2000.0 ? 0 : north < 6000.0 ? 1 : 2;
      track.add(sample(i * 0.1, eastM, north, 500.0 + tooHighM, leg));
    }
    return track;
  }

  /**
   * A flight of ten waypoints from a runway, with turns, climbs and descents; waypoint 8 is missed
   * when {@code missOne}.
   */
  public static RunPlan tenWaypoints() {
    double[][] places = {
      {1500, 900, 300},
      {4200, 2600, 600},
      {6900, 1200, 600},
      {9300, 3000, 900},
      {11500, 1000, 900},
      {11000, -2400, 700},
      {7800, -3600, 700},
      {5200, -1500, 500},
      {2400, -3300, 500},
      {300, -1500, 400}
    };
    String[] names = {
      "Departure",
      "Ridge",
      "Harbour",
      "Lighthouse",
      "East gate",
      "Reef",
      "South shore",
      "Saddle",
      "Lagoon",
      "Final"
    };
    List<RunPlan.Waypoint> waypoints = new ArrayList<>();
    for (int i = 0; i < places.length; i++) {
      waypoints.add(waypoint(names[i], places[i][0], places[i][1], places[i][2]));
    }
    return new RunPlan(
        Domain.AIR,
        Optional.of(new RunPlan.Start(LONGITUDE, LATITUDE, 4.0, Math.toRadians(60.0))),
        waypoints);
  }

  /**
   * A vehicle that flies {@link #tenWaypoints()} with limited turn and climb rates.
   *
   * @param flownLegs how many legs it flies before the flight ends
   */
  static Track pursuit(RunPlan plan, int flownLegs) {
    Track track = new Track();
    PlotPlane plane = new PlotPlane(LONGITUDE, LATITUDE);
    double east = 0.0;
    double north = 0.0;
    double altitude = 4.0;
    double heading = Math.toRadians(60.0);
    int leg = 0;
    for (int i = 0; i < 40_000 && leg < flownLegs; i++) {
      double t = i * 0.1;
      double speed = Math.min(50.0, 2.0 * t);
      boolean rolling = altitude < 5.0 && speed < 30.0;
      track.append(
          sample(t, east, north, altitude, leg, rolling, rolling ? "TAKE-OFF ROLL" : "LEG"));
      PlotPlane.Place target = plane.place(plan.waypoints().get(leg));
      double dx = target.eastM() - east;
      double dy = target.northM() - north;
      double error =
          rolling || altitude < 60.0
              ? 0.0
              : Math.IEEEremainder(Math.atan2(dx, dy) - heading, 2.0 * Math.PI);
      heading += Math.max(-0.013, Math.min(0.013, 0.05 * error));
      double wanted = plan.waypoints().get(leg).altitudeM().getAsDouble() - altitude;
      altitude += rolling ? 0.0 : Math.max(-0.6, Math.min(0.8, 0.02 * wanted));
      east += 0.1 * speed * Math.sin(heading);
      north += 0.1 * speed * Math.cos(heading);
      if (Math.hypot(dx, dy) < 70.0) {
        leg++;
      }
    }
    return track;
  }

  public static RunReport report(int flownLegs) {
    RunPlan plan = tenWaypoints();
    RunDetails facts =
        new RunDetails("cessna", 7, "embedded C172", 12.5, java.util.OptionalInt.empty());
    return RunReport.of(facts, plan, pursuit(plan, flownLegs), RunOutcome.clean());
  }
}
