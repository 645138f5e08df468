package org.u2sa.drivers.mavlink;

import io.dronefleet.mavlink.common.RcChannelsOverride;
import java.util.ArrayList;
import java.util.List;
import java.util.OptionalDouble;
import java.util.function.Function;
import java.util.function.IntUnaryOperator;
import org.u2sa.drivers.motor.PulseWidth;

/**
 * Commands that override radio channels: RC_CHANNELS_OVERRIDE. Channels 1…8 with an actuator get
 * its pulse, the others 65535, "ignore"; 0 releases a channel to the radio.
 */
final class RcOverride implements CommandForm {
  private static final int CHANNELS = 8;
  private static final int IGNORE = 65_535;
  private static final int RELEASE = 0;
  private static final double MICRO = 1.0e-6;
  private static final double FULL_PERCENT = 100.0;

  /**
   * A radio channel.
   *
   * @param channel 1…8
   * @param oneWay whether 0 % is the shortest pulse, as for an aeroplane's throttle, rather than
   *     neutral
   */
  record Channel(int channel, String actuator, boolean oneWay) {}

  private final List<Channel> channels;
  private final PulseWidth width;

  RcOverride(List<Channel> channels, PulseWidth width) {
    this.channels = channels;
    this.width = width;
  }

  @Override
  public List<Axis> axes() {
    List<Axis> axes = new ArrayList<>();
    for (Channel each : channels) {
      double minimum = each.oneWay() ? 0.0 : -FULL_PERCENT;
      axes.add(new Axis(each.actuator(), minimum, "radio channel " + each.channel()));
    }
    return axes;
  }

  @Override
  public Object message(
      Target target, Function<String, OptionalDouble> percentages, long nowMicros) {
    int[] pulses = new int[CHANNELS];
    for (Channel each : channels) {
      double percent = percentages.apply(each.actuator()).orElse(0.0);
      double twoWay = each.oneWay() ? 2.0 * Math.max(0.0, percent) - FULL_PERCENT : percent;
      pulses[each.channel() - 1] = (int) Math.round(width.seconds(twoWay) / MICRO);
    }
    return override(target, channel -> pulses[channel]);
  }

  @Override
  public List<Object> release(Target target) {
    return List.of(override(target, channel -> RELEASE));
  }

  private RcChannelsOverride override(Target target, IntUnaryOperator ofOurs) {
    int[] raw = new int[CHANNELS];
    for (int i = 0; i < CHANNELS; i++) {
      raw[i] = IGNORE;
    }
    for (Channel each : channels) {
      raw[each.channel() - 1] = ofOurs.applyAsInt(each.channel() - 1);
    }
    return RcChannelsOverride.builder() // 0 means "ignore" for channels 9…18
        .targetSystem(target.systemId())
        .targetComponent(target.componentId())
        .chan1Raw(raw[0])
        .chan2Raw(raw[1])
        .chan3Raw(raw[2])
        .chan4Raw(raw[3])
        .chan5Raw(raw[4])
        .chan6Raw(raw[5])
        .chan7Raw(raw[6])
        .chan8Raw(raw[7])
        .build();
  }
}
