package org.u2sa.device.payload;

import java.util.OptionalDouble;
import org.u2sa.device.port.Device;

/** The output that moves a switched payload: a relay, a dimmer, or the pulse of a servo. */
public interface SwitchOutput extends Device<SwitchOutput.Level> {
  /**
   * The commanded state.
   *
   * @param percent level, 0…100 [%]; empty until first set
   */
  record Level(long measuredAtMicros, OptionalDouble percent) implements Reading {}

  /**
   * Sets the level, which holds until the next one; before the first call the output is untouched.
   *
   * @param percent 0…100 [%]
   */
  void set(double percent);

  /** Releases the output without changing it, for a successor. */
  void leave();
}
