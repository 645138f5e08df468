import java.util.Locale;
import org.u2sa.messages.frame.Attitude;
import org.u2sa.messages.frame.Geodetic;
import org.u2sa.messages.frame.Point;
import org.u2sa.sim.ground.DifferentialParameters;
import org.u2sa.sim.ground.DifferentialVehicle;
import org.u2sa.sim.ground.DriveCommand;
import org.u2sa.sim.ground.DrivingHazard;
import org.u2sa.sim.ground.GroundState;
import org.u2sa.sim.sensor.CompassModel;
import org.u2sa.sim.sensor.CompassParameters;
import org.u2sa.sim.sensor.GpsModel;
import org.u2sa.sim.sensor.GpsParameters;
import org.u2sa.sim.sensor.GpsSample;
import org.u2sa.sim.sensor.NoiseStreams;
import org.u2sa.sim.vehicle.VehicleTruth;
import org.u2sa.sim.world.LocalPlane;

/**
 * Drives the simulated Mini-Molle around a square by its true place and prints what it did and what
 * its sensors would say, as CSV. plot.py makes the picture of it.
 */
public final class Drive {
  private static final double[][] CORNERS = {{0, 20}, {20, 20}, {20, 0}, {0, 0}};
  private static final double STEP_S = 0.02;

  public static void main(String[] args) {
    LocalPlane plane = new LocalPlane(new Geodetic(-80.42, 37.23, 600.0));
    NoiseStreams streams = new NoiseStreams(7L);
    GpsModel survey = new GpsModel(GpsParameters.survey(), plane, streams);
    GpsModel phone = new GpsModel(GpsParameters.phone(), plane, streams);
    CompassModel compass = new CompassModel(CompassParameters.calibrated(0.0), streams);
    DrivingHazard.Magnetic magnet = new DrivingHazard.Magnetic(20.0, 10.0, 1.0, 10.0, 0.0);
    DifferentialVehicle vehicle = new DifferentialVehicle(DifferentialParameters.miniMolle());
    System.out.println("t,east,north,speed,left,right,first,second,volts,compass,surveyE,surveyN,phoneE,phoneN");
    int corner = 0;
    for (int i = 1; corner < CORNERS.length; i++) {
      GroundState s = vehicle.state();
      double toEast = CORNERS[corner][0] - s.eastM();
      double toNorth = CORNERS[corner][1] - s.northM();
      if (Math.hypot(toEast, toNorth) < 0.3) {
        corner++;
        continue;
      }
      double error = Math.IEEEremainder(Math.atan2(toEast, toNorth) - s.headingRad(), 2 * Math.PI);
      double cruise = s.timeS() < 3.0 ? 1.0 : 0.6; // a start in which the tyres slide
      double drive = cruise * Math.max(0.0, Math.cos(error));
      double turn = Math.max(-0.25, Math.min(0.25, 0.4 * error - 0.06 * s.yawRateRadPerS()));
      double first = Math.min(1.0, drive + turn);
      double second = Math.min(1.0, drive - turn);
      vehicle.step(new DriveCommand(first, second), STEP_S);
      s = vehicle.state();
      print(plane, s, survey, phone, compass, magnet, i, first, second);
    }
  }

  private static void print(LocalPlane plane, GroundState s, GpsModel survey, GpsModel phone,
      CompassModel compass, DrivingHazard.Magnetic magnet, int i, double first, double second) {
    VehicleTruth truth = new VehicleTruth(s.timeS(), Point.of(s.eastM(), s.northM(), 0),
        new Attitude(0.0, 0.0, s.headingRad()), Point.of(s.eastMps(), s.northMps(), 0),
        Point.ORIGIN, Point.ORIGIN);
    String fixes = i % 5 == 0 ? place(plane, survey.sample(s.timeS(), truth, false)) : ",";
    fixes += "," + (i % 50 == 0 ? place(plane, phone.sample(s.timeS(), truth, false)) : ",");
    double distance = Math.hypot(s.eastM() - magnet.eastM(), s.northM() - magnet.northM());
    double share = 1.0 / (1.0 + Math.pow(distance / magnet.radiusM(), 3.0));
    double heading = compass.sample(truth,
        new CompassModel.Disturbance(share * magnet.eastUt(), share * magnet.northUt(), s.leftMotorA(), s.rightMotorA()));
    double error = Math.toDegrees(Math.IEEEremainder(heading - s.headingRad(), 2 * Math.PI));
    System.out.printf(Locale.ROOT, "%.2f,%.3f,%.3f,%.4f,%.4f,%.4f,%.3f,%.3f,%.3f,%.3f,%s%n",
        s.timeS(), s.eastM(), s.northM(), s.forwardMps(), 0.1 * s.leftWheelRadPerS(),
        0.1 * s.rightWheelRadPerS(), first, second, s.batteryV(), error, fixes);
  }

  private static String place(LocalPlane plane, GpsSample sample) {
    if (!sample.valid()) {
      return ",";
    }
    Point enu = plane.origin().enuOf(
        new Geodetic(sample.longitudeDeg(), sample.latitudeDeg(), plane.origin().altitudeM()));
    return String.format(Locale.ROOT, "%.3f,%.3f", enu.x(), enu.y());
  }

  private Drive() {}
}
