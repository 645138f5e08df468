package org.u2sa.sim.ioio;

/** The nine PWM modules. After the firmware's {@code pwm.c}. */
final class PwmModules {
  static final int COUNT = 9;

  private static final double SYSTEM_CLOCK_HZ = 16.0e6;
  private static final int[] DIVIDERS = {1, 256, 64, 8}; // indexed by the two scale bits
  private static final double QUARTER = 0.25;

  private final int[] period = new int[COUNT]; // 0: off
  private final int[] divider = new int[COUNT];
  private final int[] duty = new int[COUNT];
  private final int[] quarters = new int[COUNT];

  void reset() {
    for (int module = 0; module < COUNT; module++) {
      setPeriod(module, 0, 0);
    }
  }

  /** Sets the period and resets the duty cycle to 0. */
  void setPeriod(int module, int newPeriod, int scale) {
    period[module] = newPeriod;
    divider[module] = DIVIDERS[scale];
    duty[module] = 0;
    quarters[module] = 0;
  }

  void setDuty(int module, int clocks, int fraction) {
    duty[module] = clocks;
    quarters[module] = fraction;
  }

  /** Output of the module: registers count from 0; a duty cycle of 0 means no pulse. */
  PulseTrain pulses(int module) {
    if (period[module] == 0) {
      return PulseTrain.NONE;
    }
    double clockS = divider[module] / SYSTEM_CLOCK_HZ;
    double periodS = (period[module] + 1) * clockS;
    double clocks = duty[module] == 0 ? 0.0 : duty[module] + 1 + QUARTER * quarters[module];
    return new PulseTrain(Math.min(periodS, clocks * clockS), periodS);
  }
}
