/**
 * Servers of other protocols beside the embedded broker. Their clients are clients of the broker,
 * with a user's rights; what the protocols are belongs to other modules.
 */
package org.u2sa.core.communication.bridge;
