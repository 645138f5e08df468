package org.u2sa.core.communication;

import io.netty.buffer.ByteBuf;
import io.netty.channel.ChannelHandlerContext;
import io.netty.channel.ChannelInboundHandlerAdapter;
import io.netty.util.ReferenceCountUtil;
import org.u2sa.core.communication.limit.BrokerLimits;

/**
 * Counts every byte a client sends, including TLS overhead, before decryption and decoding, and
 * limits the bytes before its first complete packet. Confined to its connection's thread.
 */
final class ReceivedBytes extends ChannelInboundHandlerAdapter {
  private final Client session;
  private final Inflow inflow;
  private long beforeFirstPacket;

  ReceivedBytes(Client session, Inflow inflow) {
    this.session = session;
    this.inflow = inflow;
  }

  @Override
  public void channelRead(ChannelHandlerContext ctx, Object message) {
    int length = ((ByteBuf) message).readableBytes();
    inflow.received(length);
    if (session.isOut()) { // closing takes a while if the client does not read
      ReferenceCountUtil.release(message);
      return;
    }
    if (session.isPending()) {
      beforeFirstPacket += length;
      if (beforeFirstPacket > BrokerLimits.FIRST_PACKET_BYTES) {
        ReferenceCountUtil.release(message);
        session.putOutFor("connection closed, its first packet is too long");
        return;
      }
    }
    inflow.process(() -> ctx.fireChannelRead(message));
  }
}
