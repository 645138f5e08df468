package org.u2sa.messages.safety;

import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import org.u2sa.messages.goal.GoalInformation;
import org.u2sa.messages.schema.MessageType;
import org.u2sa.messages.schema.NumberField;
import org.u2sa.messages.schema.Schema;
import org.u2sa.messages.schema.U2SAData;
import org.u2sa.messages.schema.ValueField;
import org.u2sa.messages.shape.Polygon;

/** The geofence in force, published at the start and at each change. */
public final class FenceState extends U2SAData {
  private static final Schema<FenceState> SCHEMA =
      Schema.of(FenceState.class, FenceState::new, U2SAData.TYPE).since(3);
  private static final ValueField<FenceState, String> FENCE = SCHEMA.optionalText("fence");
  private static final ValueField<FenceState, String> FILE = SCHEMA.optionalText("file");
  private static final NumberField<FenceState> MARGIN = SCHEMA.number("margin", "m", 0.0, 0.0);

  private static final ValueField<FenceState, List<GoalInformation>> RALLY =
      SCHEMA.messages("rally", GoalInformation.TYPE);
  private static final NumberField<FenceState> LOWEST = SCHEMA.optionalNumber("lowest", "m");
  private static final NumberField<FenceState> HIGHEST = SCHEMA.optionalNumber("highest", "m");
  private static final ValueField<FenceState, List<Polygon>> KEEP_IN =
      SCHEMA.messages("keepIn", Polygon.TYPE);
  private static final ValueField<FenceState, List<Polygon>> KEEP_OUT =
      SCHEMA.messages("keepOut", Polygon.TYPE);

  public static final MessageType<FenceState> TYPE = SCHEMA.build();

  @Override
  public MessageType<FenceState> type() {
    return TYPE;
  }

  /**
   * Fence XML as in a file of the Safety Manager's variable FENCE, without the margin; empty: no
   * fence, or one longer than the limit of texts.
   */
  public Optional<String> fence() {
    return Optional.ofNullable(get(FENCE));
  }

  public FenceState fence(String value) {
    return put(FENCE, value);
  }

  /** File name of the fence, or the operator who ordered it; empty: no fence is in force. */
  public Optional<String> file() {
    return Optional.ofNullable(get(FILE));
  }

  public FenceState file(String value) {
    return put(FILE, value);
  }

  /** Distance by which the areas are shrunk, and forbidden ones widened, on all sides [m]. */
  public double margin() {
    return require(MARGIN);
  }

  public FenceState margin(double metres) {
    return put(MARGIN, metres);
  }

  /**
   * Waypoints to which the vehicle returns instead of its home if one is nearer: those of the fence
   * that are inside it. Their thresholds are ignored.
   */
  public List<GoalInformation> rally() {
    return require(RALLY);
  }

  public FenceState rally(List<? extends GoalInformation> value) {
    return put(RALLY, List.copyOf(value));
  }

  /**
   * Minimum altitude, raised by the margin: above sea level, or up in the frame of a local fence
   * [m]; empty: no limit.
   */
  public OptionalDouble lowest() {
    return get(LOWEST);
  }

  public FenceState lowest(double metres) {
    return put(LOWEST, metres);
  }

  /** Maximum altitude, lowered by the margin; as {@link #lowest} [m]. */
  public OptionalDouble highest() {
    return get(HIGHEST);
  }

  public FenceState highest(double metres) {
    return put(HIGHEST, metres);
  }

  /** Area to stay in, shrunk by the margin; empty: no such area, or one of too many corners. */
  public List<Polygon> keepIn() {
    return require(KEEP_IN);
  }

  public FenceState keepIn(List<Polygon> value) {
    return put(KEEP_IN, List.copyOf(value));
  }

  /** Areas to stay out of, widened by the margin; empty as {@link #keepIn}. */
  public List<Polygon> keepOut() {
    return require(KEEP_OUT);
  }

  public FenceState keepOut(List<Polygon> value) {
    return put(KEEP_OUT, List.copyOf(value));
  }
}
