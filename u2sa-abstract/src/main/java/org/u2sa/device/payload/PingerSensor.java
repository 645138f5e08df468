package org.u2sa.device.payload;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.stream.Stream;
import org.u2sa.device.DeviceSensor;
import org.u2sa.device.Devices;
import org.u2sa.device.MountingPose;
import org.u2sa.device.SensorKind;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.interfaces.configuration.Description;
import org.u2sa.interfaces.configuration.Settings;
import org.u2sa.interfaces.configuration.Variable;
import org.u2sa.messages.ObjectDescription;
import org.u2sa.messages.ObjectLevel;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.service.ServiceContext;

/**
 * Publishes an acoustic pinger as a point object in BODY, once per ping (thesis 2.2, 3.2.2.3). Out:
 * sensed-objects, uid {@code pinger} and its frequency in kHz.
 *
 * <p>An array that measures arrival times needs HYDROPHONE PLACES: the direction is then computed
 * ({@link ArrivalDirection}).
 *
 * <p>An array measures the direction, not the distance: the object is at RANGE along the direction,
 * and its standard deviations are those of RANGE SIGMA along and of the angles across it.
 */
public final class PingerSensor extends DeviceSensor<HydrophoneArray.Heard> {
  private static final double HZ_PER_KHZ = 1_000.0;
  private static final SensorKind<HydrophoneArray> KIND =
      new SensorKind<>(
          "PingerSensor",
          HydrophoneArray.class,
          new Devices.Usual(
              "hydrophone array", "HYDROPHONES", "NMEA", "serial:/dev/ttyUSB0?baud=115200"),
          Channels.SENSED_OBJECTS,
          20.0, // Hz
          10.0); // s

  private record Variables(
      @Variable(unit = "Hz", min = 0, max = 1e6, ifAbsent = 0)
          @Description("Frequency of the pinger; 0: any.")
          double frequency,
      @Variable(unit = "Hz", min = 1, max = 1e5, ifAbsent = 500)
          @Description(
              "Difference from FREQUENCY beyond which a ping is attributed to another pinger.")
          double frequencyTolerance,
      @Variable(ifAbsentText = "pinger") @Description("Type of the object.") String objectType,
      @Variable(unit = "m", min = 0.1, max = 10_000, ifAbsent = 10)
          @Description("Assumed distance of the object, because none is measured.")
          double range,
      @Variable(unit = "m", min = 0.01, max = 10_000, ifAbsent = 10)
          @Description("Standard deviation of that distance.")
          double rangeSigma,
      @Variable(unit = "rad", min = 0.0001, max = 3, ifAbsent = 0.1)
          @Description("Standard deviation of the angles, if the array reports none.")
          double angleSigma,
      @Variable(ifAbsentText = "")
          @Description(
              "Positions of the hydrophones relative to MOUNTED X, Y, Z [m]: forward, left and down of each, such as \"0.1 0 0; 0 0.1 0; …\", for an array that measures arrival times.")
          String hydrophonePlaces,
      @Variable(unit = "m/s", min = 1000, max = 2000, ifAbsent = 1500)
          @Description("Speed of sound in the water.")
          double soundSpeed,
      @Variable(unit = "s", min = 1e-9, max = 0.01, ifAbsent = 2e-6)
          @Description("Standard deviation of an arrival time.")
          double arrivalSigma,
      @Variable(min = 1, max = 1000, ifAbsent = 4)
          @Description(
              "RMS error of the arrival times, in standard deviations, above which a ping is ignored as an echo.")
          double echoGate) {
    Variables {
      places(hydrophonePlaces);
    }

    private static List<Point> places(String text) {
      List<Point> places = new ArrayList<>();
      for (String place : text.split(";")) {
        String[] parts = place.trim().split("[\\s,]+");
        if (parts.length == 3) {
          double left = Double.parseDouble(parts[1]);
          places.add(Point.of(Double.parseDouble(parts[0]), left, Double.parseDouble(parts[2])));
        } else if (!place.trim().isEmpty()) {
          throw new IllegalArgumentException(
              "HYDROPHONE PLACES \"" + place.trim() + "\": expected three numbers in m");
        }
      }
      if (!places.isEmpty() && places.size() < 3) {
        throw new IllegalArgumentException("HYDROPHONE PLACES: expected at least 3 places");
      }
      return places;
    }

    List<Point> places() {
      return places(hydrophonePlaces);
    }
  }

  private long heard;
  private long echoes;

  private final Settings<Variables> tuning = settings(Variables.class);
  private final MountingPose mounted = settings(MountingPose.class).get();

  public PingerSensor(ServiceContext context) {
    super(context, KIND);
  }

  public PingerSensor(ServiceContext context, HydrophoneArray array) {
    super(context, KIND, array);
  }

  @Override
  protected Stream<ObjectDescription> messages(HydrophoneArray.Heard ping) {
    Variables now = tuning.get();
    boolean isOther =
        now.frequency() > 0.0
            && !(Math.abs(ping.frequencyHz() - now.frequency()) <= now.frequencyTolerance());
    if (isOther) {
      return Stream.empty();
    }
    return ping instanceof HydrophoneArray.Arrivals times
        ? computed(times, now)
        : measured((HydrophoneArray.Ping) ping, now);
  }

  private Stream<ObjectDescription> measured(HydrophoneArray.Ping ping, Variables now) {
    double level = Math.cos(ping.elevationRad());
    Point direction =
        Point.of(
            level * Math.cos(ping.azimuthRad()),
            level * Math.sin(ping.azimuthRad()),
            -Math.sin(ping.elevationRad()));
    double sigmaRad = ping.sigmaRad().orElse(now.angleSigma());
    return Stream.of(pinger(direction, sigmaRad, ping.frequencyHz(), now));
  }

  private Stream<ObjectDescription> computed(HydrophoneArray.Arrivals ping, Variables now) {
    List<Point> places = now.places();
    if (ping.arrivalsS().size() != places.size()) {
      throw new IllegalArgumentException(
          ping.arrivalsS().size() + " arrival times; HYDROPHONE PLACES has " + places.size());
    }
    ArrivalDirection solved =
        ArrivalDirection.of(places, ping.arrivalsS(), now.soundSpeed(), now.arrivalSigma());
    boolean isEcho = !(solved.residualS() <= now.echoGate() * now.arrivalSigma());
    heard++;
    echoes += isEcho ? 1 : 0;
    remark("HEARD", heard + " pings; " + echoes + " of them echoes, ignored");
    return isEcho
        ? Stream.empty()
        : Stream.of(pinger(solved.direction(), solved.sigmaRad(), ping.frequencyHz(), now));
  }

  private ObjectDescription pinger(
      Point direction, double sigmaRad, double frequencyHz, Variables now) {
    Point place = mounted.turn().toBody(direction.times(now.range()));
    Point along = mounted.turn().toBody(direction).minus(mounted.turn().toBody(Point.ORIGIN));
    double acrossM = sigmaRad * now.range();
    ObjectDescription pinger = new ObjectDescription();
    pinger
        .uid(String.format(Locale.ROOT, "pinger %.1f", frequencyHz / HZ_PER_KHZ))
        .objectType(now.objectType())
        .referenceFrame(ReferenceFrame.BODY)
        .x(place.x())
        .y(place.y())
        .z(place.z())
        .level(ObjectLevel.HINDRANCE)
        .sensorName(sensorName());
    pinger
        .motion()
        .sigma(
            Point.of(
                sigma(along.x(), now.rangeSigma(), acrossM),
                sigma(along.y(), now.rangeSigma(), acrossM),
                sigma(along.z(), now.rangeSigma(), acrossM)));
    return pinger;
  }

  /** Standard deviation along one axis; {@code share} is the direction's component along it. */
  private static double sigma(double share, double alongM, double acrossM) {
    double across = Math.sqrt(Math.max(0.0, 1.0 - share * share));
    return Math.hypot(share * alongM, across * acrossM);
  }
}
