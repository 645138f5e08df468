package org.u2sa.recorder.foxglove;

import java.io.IOException;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.u2sa.interfaces.communication.Channel;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.messages.CameraImage;
import org.u2sa.messages.ObjectDescription;
import org.u2sa.messages.ObjectList;
import org.u2sa.messages.OccupancyGrid;
import org.u2sa.messages.PlannedPath;
import org.u2sa.messages.RangeScan;
import org.u2sa.messages.StateInformation;
import org.u2sa.messages.contract.Condition;
import org.u2sa.messages.contract.ServiceCondition;
import org.u2sa.messages.frame.Geodetic;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.frame.UtmGrid;
import org.u2sa.messages.safety.FailsafeAction;
import org.u2sa.messages.safety.FailsafeState;
import org.u2sa.messages.schema.U2SAData;

/**
 * Converts a vehicle's messages for viewers: pose and track, detections, scans and maps, planned
 * path, faults. Not thread-safe. The first global state becomes the map's origin.
 */
public final class FoxgloveMessages {
  private static final int INFO = 2;
  private static final int WARNING = 3;
  private static final int UINT8 = 1;
  private static final double PERCENT = 100.0;
  private static final int UNKNOWN_CELL = 255;
  private static final int DELETE_ALL = 1;

  private final String prefix;
  private final SceneFrame frames = new SceneFrame();
  private final SceneShapes shapes = new SceneShapes(frames);
  private final SchemaFiles schemas = new SchemaFiles();
  private final Map<String, String> logged = new HashMap<>(); // last log line of each source

  /**
   * A message for viewers.
   *
   * @param topic topic of its channel
   * @param schemaName full name of its type
   * @param schemaData FileDescriptorSet of its type
   * @param data encoded message
   */
  public record View(String topic, String schemaName, byte[] schemaData, byte[] data) {}

  /** Receives views. */
  @FunctionalInterface
  public interface Sink {
    void write(View view) throws IOException;
  }

  /** Cache of the schemas. */
  private static final class SchemaFiles {
    private final byte[][] files = new byte[FoxgloveSchema.values().length][];

    byte[] of(FoxgloveSchema schema) {
      if (files[schema.ordinal()] == null) {
        files[schema.ordinal()] = schema.descriptors();
      }
      return files[schema.ordinal()];
    }
  }

  /** Creates a converter for one system's messages; topics start with its ID. */
  public FoxgloveMessages(String systemId) {
    prefix = "/" + systemId + "/";
  }

  /**
   * Writes the views of a message; many messages have none.
   *
   * @param nanos recording time [ns]
   * @throws IOException if the sink throws it
   */
  public void write(Channel<?> channel, U2SAData message, long nanos, Sink sink)
      throws IOException {
    if (message instanceof StateInformation state) {
      if (channel.equals(Channels.STATE)) {
        state(state, nanos, sink);
      }
    } else if (message instanceof RangeScan scan) {
      scan(scan, nanos, sink);
    } else if (message instanceof OccupancyGrid grid) {
      grid(grid, nanos, sink);
    } else if (message instanceof CameraImage image) {
      sink.write(
          view(
              "image/" + image.sensorName(),
              FoxgloveSchema.COMPRESSED_IMAGE,
              new ProtobufMessage()
                  .time(1, nanos)
                  .data(2, image.data().toBytes())
                  .text(3, image.format())
                  .text(4, image.sensorName())));
    } else if (message instanceof ObjectList list) {
      objects(list.objects(), nanos, sink);
    } else if (message instanceof PlannedPath path) {
      Optional<ProtobufMessage> entity = shapes.path(path, nanos);
      if (entity.isPresent()) {
        ProtobufMessage update = new ProtobufMessage().message(2, entity.get());
        sink.write(view("plan", FoxgloveSchema.SCENE_UPDATE, update));
      }
    } else if (message instanceof FailsafeState failsafe) {
      boolean goesOn = failsafe.action() == FailsafeAction.CONTINUE;
      String text = failsafe.action() + ": " + String.join("; ", failsafe.causes());
      log(nanos, goesOn ? INFO : WARNING, "failsafe", text, sink);
    } else if (message instanceof ServiceCondition condition) {
      boolean alive = condition.condition() == Condition.ALIVE;
      String text = condition.condition() + " " + condition.reason();
      log(nanos, alive ? INFO : WARNING, condition.serviceName(), text, sink);
    }
  }

  private View view(String topic, FoxgloveSchema schema, ProtobufMessage message) {
    return new View(prefix + topic, schema.fullName(), schemas.of(schema), message.bytes());
  }

  /** States are published repeatedly; logs a line only when one changes. */
  private void log(long nanos, int level, String name, String text, Sink sink) throws IOException {
    if (!text.equals(logged.put(name, text))) {
      sink.write(
          view(
              "log",
              FoxgloveSchema.LOG,
              new ProtobufMessage().time(1, nanos).whole(2, level).text(3, text).text(4, name)));
    }
  }

  private void state(StateInformation state, long nanos, Sink sink) throws IOException {
    if (!state.referenceFrame().isEarth() || state.x().isEmpty() || state.y().isEmpty()) {
      return;
    }
    Point own = Point.of(state.x().getAsDouble(), state.y().getAsDouble(), state.z().orElse(0.0));
    Geodetic place = Geodetic.of(UtmGrid.global(state.referenceFrame(), own));
    sink.write(view("location", FoxgloveSchema.LOCATION_FIX, locationFix(state, place, nanos)));
    Point at = frames.onMap(place);
    ProtobufMessage attitude =
        SceneFrame.attitude(
            state.phi().orElse(0.0), state.theta().orElse(0.0), state.psi().orElse(0.0));
    sink.write(
        view(
            "pose",
            FoxgloveSchema.POSE_IN_FRAME,
            new ProtobufMessage()
                .time(1, nanos)
                .text(2, SceneFrame.MAP)
                .message(3, SceneFrame.pose(at, attitude))));
    sink.write(
        view(
            "transform",
            FoxgloveSchema.FRAME_TRANSFORM,
            new ProtobufMessage()
                .time(1, nanos)
                .text(2, SceneFrame.MAP)
                .text(3, SceneFrame.BODY)
                .message(4, SceneFrame.vector(at))
                .message(5, attitude)));
  }

  private static ProtobufMessage locationFix(StateInformation state, Geodetic place, long nanos) {
    ProtobufMessage fix =
        new ProtobufMessage()
            .number(1, place.latitudeDeg())
            .number(2, place.longitudeDeg())
            .number(3, place.altitudeM());
    if (state.xSigma().isPresent() && state.ySigma().isPresent() && state.zSigma().isPresent()) {
      double[] covariance = new double[9]; // row-major: east, north, up [m²]
      covariance[0] = square(state.xSigma().getAsDouble());
      covariance[4] = square(state.ySigma().getAsDouble());
      covariance[8] = square(state.zSigma().getAsDouble());
      int diagonalKnown = 2;
      fix.numbers(4, covariance).whole(5, diagonalKnown);
    }
    return fix.time(6, nanos).text(7, SceneFrame.BODY);
  }

  private static double square(double value) {
    return value * value;
  }

  private void scan(RangeScan scan, long nanos, Sink sink) throws IOException {
    Optional<SceneFrame.Placed> at =
        frames.place(scan.referenceFrame(), Point.of(scan.x(), scan.y(), scan.z()));
    List<RangeScan.Beam> beams = scan.beams();
    if (at.isEmpty() || beams.isEmpty() || !scan.angles().isEmpty()) {
      return; // Foxglove's scans have equal steps
    }
    double[] ranges = new double[beams.size()];
    for (int i = 0; i < ranges.length; i++) {
      ranges[i] = beams.get(i).range().orElse(Double.POSITIVE_INFINITY);
    }
    sink.write(
        view(
            "scan/" + scan.sensorName(),
            FoxgloveSchema.LASER_SCAN,
            new ProtobufMessage()
                .time(1, nanos)
                .text(2, at.get().frame())
                .message(3, SceneFrame.pose(at.get().point(), SceneFrame.aboutUp(scan.psi())))
                .number(4, beams.get(0).angle())
                .number(5, beams.get(beams.size() - 1).angle())
                .numbers(6, ranges)));
  }

  private void grid(OccupancyGrid grid, long nanos, Sink sink) throws IOException {
    Optional<SceneFrame.Placed> anchor = frames.place(grid.referenceFrame(), grid.anchor());
    if (anchor.isEmpty() || grid.columns() == 0) {
      return;
    }
    byte[] cells = grid.cells();
    for (int i = 0; i < cells.length; i++) {
      cells[i] =
          cells[i] == OccupancyGrid.UNKNOWN
              ? (byte) UNKNOWN_CELL
              : (byte) Math.round(PERCENT * OccupancyGrid.probability(cells[i]));
    }
    Point corner = anchor.get().point().plus(Point.of(grid.left(), grid.bottom(), 0.0));
    ProtobufMessage field = new ProtobufMessage().text(1, "occupancy").whole(3, UINT8);
    sink.write(
        view(
            "grid",
            FoxgloveSchema.GRID,
            new ProtobufMessage()
                .time(1, nanos)
                .text(2, anchor.get().frame())
                .message(3, SceneFrame.pose(corner, SceneFrame.aboutUp(0.0)))
                .fixed32(4, grid.columns())
                .message(
                    5,
                    new ProtobufMessage().number(1, grid.resolution()).number(2, grid.resolution()))
                .fixed32(6, grid.columns())
                .fixed32(7, 1)
                .message(8, field)
                .data(9, cells)));
  }

  private void objects(List<ObjectDescription> objects, long nanos, Sink sink) throws IOException {
    ProtobufMessage update =
        new ProtobufMessage().message(1, new ProtobufMessage().time(1, nanos).whole(2, DELETE_ALL));
    for (ObjectDescription object : objects) {
      shapes.object(object, nanos).ifPresent(entity -> update.message(2, entity));
    }
    sink.write(view("objects", FoxgloveSchema.SCENE_UPDATE, update));
  }
}
