package org.u2sa.device.port;

import java.util.List;

/** A receiver of a pilot's radio control. */
public interface RadioReceiver extends Device<RadioReceiver.Pulses> {
  /**
   * The channels of one frame.
   *
   * @param widthsS width of each channel's pulse, from channel 1 [s], about 0.001…0.002
   */
  record Pulses(long measuredAtMicros, List<Double> widthsS) implements Reading {
    public Pulses {
      widthsS = List.copyOf(widthsS);
    }
  }
}
