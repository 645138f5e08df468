package org.u2sa.drivers.range;

import java.util.Optional;
import org.u2sa.drivers.link.ByteLink;
import org.u2sa.drivers.link.ByteLinks;
import org.u2sa.drivers.link.LinkWatch;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.interfaces.configuration.VariableDeclaration;
import org.u2sa.messages.ObjectDescription;
import org.u2sa.messages.frame.Point;
import org.u2sa.messages.frame.ReferenceFrame;
import org.u2sa.service.ExteroceptiveSensor;
import org.u2sa.service.ServiceContext;

/**
 * A range finder with one beam, as an ultrasonic one (thesis 4.1.2): the nearest thing that it
 * sees, as a point in BODY. Out: sensed-objects, when something is in reach.
 */
public final class RangeSensor extends ExteroceptiveSensor {
  private static final double STEPS_PER_S = 50.0;
  private static final double SILENT_AFTER_S = 0.5; // the slowest measures 7 times a second

  static final VariableDeclaration<String> CONNECTION =
      VariableDeclaration.text("CONNECTION")
          .ifAbsent("serial:/dev/ttyUSB0?baud=9600")
          .describedAs("Where the range finder is: serial:DEVICE?baud=N or tcp:HOST:PORT.");

  static final VariableDeclaration<String> MODEL =
      VariableDeclaration.text("MODEL")
          .oneOf("LV", "XL", "HR")
          .ifAbsent("LV")
          .describedAs("MaxBotix family: LV says inches, XL centimetres, HR millimetres.");

  private final RangeFinder finder;
  private final LinkWatch watch;
  private final MountingPose.Turn mounted;
  private long publishedMicros = RangeFinder.NONE.measuredAtMicros();

  /** Called by the launcher: opens the link that CONNECTION names. */
  public RangeSensor(ServiceContext context) {
    this(context, Optional.empty());
  }

  /** Over a link that the host made, whatever CONNECTION says. */
  public RangeSensor(ServiceContext context, ByteLink link) {
    this(context, Optional.of(link));
  }

  private RangeSensor(ServiceContext context, Optional<ByteLink> given) {
    super(context, "RangeSensor", STEPS_PER_S);
    mounted = MountingPose.read(this).turn();
    String address = getVariable(CONNECTION);
    ByteLink link =
        given.orElseGet(
            () ->
                ByteLinks.open(
                    address,
                    context.clock(),
                    path -> context.configuration().resolve(path.toString())));
    watch = new LinkWatch(this, "the range finder", link, SILENT_AFTER_S);
    finder = new SerialSonar(link, SonarModel.valueOf(getVariable(MODEL)));
  }

  @Override
  protected void step(double nowS) {
    long now = clock().micros();
    watch.look(now);
    RangeFinder.Reading reading = finder.read(now);
    watch.malformed(finder.malformed());
    if (reading.measuredAtMicros() == publishedMicros) {
      return;
    }
    publishedMicros = reading.measuredAtMicros();
    watch.heard(now);
    reading.rangeM().ifPresent(this::publish);
  }

  private void publish(double rangeM) {
    Point seen = mounted.toBody(Point.of(rangeM, 0.0, 0.0));
    ObjectDescription object =
        new ObjectDescription()
            .uid(sensorName())
            .referenceFrame(ReferenceFrame.BODY)
            .x(seen.x())
            .y(seen.y())
            .z(seen.z());
    object.timestamp(publishedMicros);
    publish(Channels.SENSED_OBJECTS, object);
  }

  @Override
  protected void release() {
    finder.close();
  }
}
