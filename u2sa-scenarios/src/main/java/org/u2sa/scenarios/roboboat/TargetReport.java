package org.u2sa.scenarios.roboboat;

import org.u2sa.interfaces.communication.Channel;
import org.u2sa.messages.schema.MessageType;
import org.u2sa.messages.schema.NumberField;
import org.u2sa.messages.schema.Schema;
import org.u2sa.messages.schema.U2SAData;
import org.u2sa.messages.schema.ValueField;

/** Report of a target's position to the judges over the competition's network (thesis 4.2). */
public final class TargetReport extends U2SAData {
  private static final Schema<TargetReport> SCHEMA =
      Schema.of(TargetReport.class, TargetReport::new, U2SAData.TYPE);
  private static final ValueField<TargetReport, String> TARGET = SCHEMA.requiredName("target");
  private static final NumberField<TargetReport> X = SCHEMA.requiredCoordinate("x");
  private static final NumberField<TargetReport> Y = SCHEMA.requiredCoordinate("y");

  public static final MessageType<TargetReport> TYPE = SCHEMA.build();

  /** Reports to the judges. */
  public static final Channel<TargetReport> CHANNEL = Channel.every("target-reports", TYPE);

  @Override
  public MessageType<TargetReport> type() {
    return TYPE;
  }

  /** Type of the target, such as "hot target". */
  public String target() {
    return require(TARGET);
  }

  TargetReport target(String name) {
    return put(TARGET, name);
  }

  /** Longitude [deg]. */
  public double x() {
    return require(X);
  }

  /** Latitude [deg]. */
  public double y() {
    return require(Y);
  }

  TargetReport place(double longitudeDeg, double latitudeDeg) {
    return put(X, longitudeDeg).put(Y, latitudeDeg);
  }
}
