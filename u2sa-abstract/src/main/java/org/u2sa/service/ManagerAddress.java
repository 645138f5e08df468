package org.u2sa.service;

import org.u2sa.interfaces.communication.Transport;
import org.u2sa.interfaces.configuration.Description;
import org.u2sa.interfaces.configuration.Variable;
import org.u2sa.interfaces.mqtt.BrokerAccess;
import org.u2sa.interfaces.mqtt.MqttTransport;
import org.u2sa.messages.schema.MessageCodec;

/** Address of the Communication Manager, if it runs in another process. */
record ManagerAddress(
    @Variable(name = "COMMUNICATION MANAGER IP", ifAbsentText = "localhost")
        @Description("Host of the Communication Manager, if it runs in another process.")
        String host,
    @Variable(name = "COMMUNICATION MANAGER PORT", min = 1, max = 65_535, ifAbsent = 1883)
        @Description("TCP port of the Communication Manager, if it runs in another process.")
        int port) {

  /** The transport to the configured address. */
  static Transport transport(ServiceContext context) {
    ManagerAddress address = context.configuration().settings(ManagerAddress.class).get();
    return new MqttTransport(
        address.host(),
        address.port(),
        context.systemId(),
        new MessageCodec(context.messageTypes()),
        BrokerAccess.configured(context.configuration()));
  }
}
