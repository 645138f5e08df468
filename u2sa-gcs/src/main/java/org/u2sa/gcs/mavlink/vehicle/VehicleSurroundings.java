package org.u2sa.gcs.mavlink.vehicle;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.concurrent.ConcurrentSkipListMap;
import java.util.function.LongSupplier;
import java.util.stream.Collectors;
import org.u2sa.interfaces.communication.Channel;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.messages.ObjectList;
import org.u2sa.messages.RangeScan;
import org.u2sa.messages.command.PercentageCommand;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.messages.schema.U2SAData;
import org.u2sa.messages.shape.MovingSphere;

/**
 * The vehicle's surroundings, and the commands of its actuators. {@link #take} may be called on any
 * thread.
 */
public final class VehicleSurroundings {
  /** Channels to subscribe to. */
  public static final List<Channel<?>> CHANNELS =
      List.of(Channels.SCANS, Channels.OBJECTS, Channels.ACTUATION);

  private static final String AIRCRAFT = "aircraft";
  private static final String THROTTLE = "THROTTLE";
  private static final int MAX_OUTPUTS = 64;
  private static final long FRESH_MICROS = 2_000_000;

  private record Heard<T>(T message, long micros) {}

  private final LongSupplier micros;
  private final Map<String, Heard<Double>> outputs = new ConcurrentSkipListMap<>();
  private volatile Heard<RangeScan> scan; // null until heard
  private volatile ObjectList objects; // null until heard

  /**
   * @param micros real time [µs]
   */
  public VehicleSurroundings(LongSupplier micros) {
    this.micros = micros;
  }

  /** Takes a message of any of {@link #CHANNELS}. */
  public void take(U2SAData message) {
    long now = micros.getAsLong();
    if (message instanceof RangeScan seen && seen.referenceFrame().equals(ReferenceFrame.BODY)) {
      scan = new Heard<>(seen, now);
    } else if (message instanceof ObjectList list) {
      objects = list;
    } else if (message instanceof PercentageCommand command
        && (outputs.size() < MAX_OUTPUTS || outputs.containsKey(command.actuatorName()))) {
      outputs.put(command.actuatorName(), new Heard<>(command.percentage(), now));
    }
  }

  /** Newest scan of any scanner; empty if none arrived within 2 s. */
  public Optional<RangeScan> scan() {
    return Optional.ofNullable(scan).filter(this::isFresh).map(Heard::message);
  }

  /** Other aircraft known to the World Modeler, if their position is global. */
  public List<MovingSphere> aircraft() {
    return Optional.ofNullable(objects).stream()
        .flatMap(list -> list.objects().stream())
        .filter(MovingSphere.class::isInstance)
        .map(MovingSphere.class::cast)
        .filter(each -> each.objectType().equals(AIRCRAFT))
        .filter(each -> each.referenceFrame().equals(ReferenceFrame.GLOBAL))
        .collect(Collectors.toList());
  }

  /** Commands of the last 2 s [%], in the order of the actuators' names. */
  public List<Double> outputs() {
    return outputs.values().stream()
        .filter(this::isFresh)
        .map(Heard::message)
        .collect(Collectors.toList());
  }

  /** Command of the last 2 s to the actuator {@value #THROTTLE} [%], 0 to 100. */
  public OptionalDouble throttle() {
    return Optional.ofNullable(outputs.get(THROTTLE)).filter(this::isFresh).stream()
        .mapToDouble(command -> Math.max(0.0, Math.min(100.0, command.message())))
        .findFirst();
  }

  private boolean isFresh(Heard<?> heard) {
    return micros.getAsLong() - heard.micros() <= FRESH_MICROS;
  }
}
