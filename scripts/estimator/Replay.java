import java.io.BufferedReader;
import java.io.IOException;
import java.io.PrintWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Locale;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import org.u2sa.estimation.fusion.ErrorStateFilter;
import org.u2sa.estimation.fusion.Estimate;
import org.u2sa.estimation.fusion.FilterTuning;
import org.u2sa.estimation.measurement.Measurement;
import org.u2sa.estimation.measurement.MeasurementReader;
import org.u2sa.estimation.fusion.MotionDomain;
import org.u2sa.estimation.measurement.UsualSigmas;
import org.u2sa.interfaces.configuration.XmlConfiguration;
import org.u2sa.messages.InertialMeasurement;
import org.u2sa.messages.ObjectDescription;
import org.u2sa.messages.StateField;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.estimation.EstimateWriter;
import org.u2sa.world.landmark.LandmarkModeller;
import org.u2sa.world.modeller.MapFrame;
import org.u2sa.world.modeller.Sighting;

/**
 * Runs the fusing State Estimator's filter over a recording that recordings.py wrote: Replay DOMAIN
 * IN OUT. Lines, in the order of arrival:
 *
 * <pre>
 * S micros source frame field=value …     a StateInformation
 * I micros source wx wy wz fx fy fz       an InertialMeasurement in BODY_FRD
 * M micros source mx my mz declination σ  a magnetometer, tilt-compensated here
 * L micros source x y range bearing σr σb a landmark of known place, seen; LOCAL_ENU
 * O micros source uid range bearing σr σb an object, seen; the World Modeler's LANDMARKS recognises it
 * K micros uid x y                        that object's place is known beforehand; LOCAL_ENU
 * </pre>
 */
final class Replay {
  private static final long OUTPUT_MICROS = 50_000;

  private final ErrorStateFilter filter;
  private final MeasurementReader reader = new MeasurementReader(new UsualSigmas(3.0, 0.3, 0.05, 0.015, 0.35, 1.0));
  private final Measurement measurement = new Measurement();
  private final Map<String, StateField> fields = new TreeMap<>();

  private final LandmarkModeller landmarks =
      new LandmarkModeller(
          XmlConfiguration.inMemory(
              "replay", Map.of("LANDMARK TYPES", "landmark", "LEARN LANDMARKS", true, "LANDMARK SIGMA", 0.02)));
  private final List<ObjectDescription> known = new java.util.ArrayList<>();
  private MapFrame frame;

  private Replay(FilterTuning tuning) {
    filter = new ErrorStateFilter(tuning);
    for (StateField field : StateField.values()) {
      fields.put(field.fieldName(), field);
    }
  }

  public static void main(String[] args) throws IOException {
    FilterTuning tuning = FilterTuning.of(MotionDomain.valueOf(args[0]));
    Replay replay = new Replay(tuning);
    long began = System.nanoTime();
    long count = 0;
    try (BufferedReader in = Files.newBufferedReader(Path.of(args[1]));
        PrintWriter out = new PrintWriter(Files.newBufferedWriter(Path.of(args[2])))) {
      long written = 0;
      for (String line = in.readLine(); line != null; line = in.readLine()) {
        replay.fuse(line.split(" "));
        count++;
        if (replay.filter.micros() - written >= OUTPUT_MICROS) {
          written = replay.filter.micros();
          out.println(text(replay.filter.at(written)));
        }
      }
    }
    System.err.printf(
        Locale.ROOT, "%d measurements, %.1f µs each%n", count, (System.nanoTime() - began) / 1e3 / count);
    replay.filter.sources().at(replay.filter.micros()).forEach(each -> System.err.println(each.text()));
    System.err.println("reset " + replay.filter.resets() + "; " + replay.landmarks.remark());
  }

  private void fuse(String[] w) {
    long micros = Long.parseLong(w[1]);
    double[] n = new double[w.length];
    for (int i = w[0].equals("O") ? 4 : 3; i < w.length && !w[0].equals("S"); i++) {
      n[i] = Double.parseDouble(w[i]);
    }
    switch (w[0]) {
      case "S":
        StateInformation state = new StateInformation().referenceFrame(ReferenceFrame.parse(w[3]));
        for (int i = 4; i < w.length; i++) {
          String[] each = w[i].split("=");
          state.number(fields.get(each[0]), Double.parseDouble(each[1]));
        }
        add(state, w[2], micros);
        break;
      case "I":
        InertialMeasurement inertial = new InertialMeasurement();
        inertial.rollRate(n[3]).pitchRate(n[4]).yawRate(n[5]);
        inertial.specificForceX(n[6]).specificForceY(n[7]).specificForceZ(n[8]);
        add(inertial, w[2], micros);
        break;
      case "M":
        magnetometer(w[2], micros, n);
        break;
      case "K":
        ObjectDescription object = new ObjectDescription().uid(w[2]).objectType("landmark");
        known.add(object.referenceFrame(ReferenceFrame.LOCAL_ENU).x(n[3]).y(n[4]));
        break;
      case "O":
        object(w[2], w[3], micros, n);
        break;
      case "L":
        landmark(w[2], micros, n);
        break;
      default:
        throw new IllegalArgumentException("line of kind " + w[0]);
    }
  }

  private void add(StateInformation message, String source, long micros) {
    message.sensorName(source).timestamp(micros);
    filter.add(reader.read(message, measurement));
  }

  private void magnetometer(String source, long micros, double[] n) {
    Estimate e = filter.at(micros);
    if (!e.hasTilt()) {
      return;
    }
    double sr = Math.sin(e.phi());
    double cr = Math.cos(e.phi());
    double sp = Math.sin(e.theta());
    double cp = Math.cos(e.theta());
    double forward = n[3] * cp + n[4] * sr * sp + n[5] * cr * sp;
    double right = n[4] * cr - n[5] * sr;
    double psi = Math.atan2(-right, forward) + n[6];
    add(new StateInformation().psi(psi).psiSigma(n[7]), source, micros);
  }

  private void landmark(String source, long micros, double[] n) {
    double bearing = -n[6]; // counter-clockwise in the recording
    measurement.begin(source, micros).sighting(n[5], bearing, n[7], n[8]).ofLocal(n[4], n[3]);
    filter.add(measurement);
  }

  private void object(String source, String uid, long micros, double[] n) {
    Estimate estimate = filter.at(micros);
    StateInformation vehicle = EstimateWriter.write(estimate);
    boolean isPlaced = estimate.hasPosition() && estimate.hasHeading();
    Sighting sighting =
        new Sighting(micros, frame == null ? MapFrame.of(vehicle) : frame, isPlaced ? Optional.of(vehicle) : Optional.empty());
    if (frame == null) {
      frame = sighting.frame();
      landmarks.enter(frame, sighting);
      landmarks.known(
          known.stream().map(each -> each.in(ReferenceFrame.LOCAL_NED, null)).collect(java.util.stream.Collectors.toList()), sighting);
    }
    ObjectDescription seen =
        new ObjectDescription().uid(uid).objectType("landmark").sensorName(source).referenceFrame(ReferenceFrame.BODY_FLU);
    double c = Math.cos(n[5]);
    double s = Math.sin(n[5]);
    seen.x(n[4] * c).y(n[4] * s);
    double across = n[4] * n[7];
    seen.motion().sigma(Point.of(Math.hypot(n[6] * c, across * s), Math.hypot(n[6] * s, across * c), 0.1));
    landmarks.objects(List.of(seen), sighting);
    for (StateInformation each : landmarks.corrections()) {
      filter.add(reader.read(each, measurement));
    }
  }

  private static String text(Estimate e) {
    return String.format(
        Locale.ROOT,
        "%d %b %b %.10f %.10f %.4f %.5f %.5f %.5f %.5f %.5f %.5f %.6f %.6f %.6f %.4f %.4f %.4f %.5f",
        e.micros(),
        e.hasPosition(),
        e.hasHeading(),
        e.latitudeDeg(),
        e.longitudeDeg(),
        e.altitudeM(),
        e.localM(0),
        e.localM(1),
        e.localM(2),
        e.velocityMps(0),
        e.velocityMps(1),
        e.velocityMps(2),
        e.phi(),
        e.theta(),
        e.psi(),
        e.positionSigmaM(0),
        e.positionSigmaM(1),
        e.positionSigmaM(2),
        e.attitudeSigma(2));
  }
}
