package org.u2sa.core.communication;

import io.netty.buffer.ByteBuf;
import io.netty.channel.ChannelHandlerContext;
import io.netty.channel.ChannelInboundHandlerAdapter;
import io.netty.util.ReferenceCountUtil;

/**
 * Bounds what a stranger may send before its first packet is whole, which would be kept until then.
 * Belongs to its connection's thread.
 */
final class FirstBytes extends ChannelInboundHandlerAdapter {
  private final ClientSession gate;
  private long bytes;

  FirstBytes(ClientSession gate) {
    this.gate = gate;
  }

  @Override
  public void channelRead(ChannelHandlerContext ctx, Object message) {
    bytes += ((ByteBuf) message).readableBytes();
    if (!gate.isStranger()) {
      ctx.fireChannelRead(message);
      ctx.pipeline().remove(this);
    } else if (bytes > BrokerLimits.STRANGERS_BYTES) {
      ReferenceCountUtil.release(message);
      gate.putOutFor("connection closed, its first packet is too long");
    } else {
      ctx.fireChannelRead(message);
    }
  }
}
