package org.u2sa.device;

import org.u2sa.device.port.Device;
import org.u2sa.interfaces.communication.Channel;
import org.u2sa.interfaces.communication.Channels;
import org.u2sa.service.ServiceRole;

/**
 * Properties of one kind of {@link DeviceSensor}, besides its messages.
 *
 * @param serviceName default name of the service
 * @param usual device that it opens by default
 * @param rateHz default reading rate [Hz]
 * @param silentAfterS default time without a new reading after which a connected device counts as
 *     silent [s]
 */
public record SensorKind<D extends Device<?>>(
    String serviceName,
    Class<D> port,
    Devices.Usual usual,
    Channel<?> channel,
    double rateHz,
    double silentAfterS) {

  /**
   * Whether the sensor measures the vehicle itself (thesis 3.2.2.4) or its environment (3.2.2.3).
   */
  ServiceRole role() {
    return channel.equals(Channels.SENSED_STATE)
        ? ServiceRole.PROPRIOCEPTIVE_SENSOR
        : ServiceRole.EXTEROCEPTIVE_SENSOR;
  }
}
