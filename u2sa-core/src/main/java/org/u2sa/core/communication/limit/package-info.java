/** Limits of rates, connections and time, per client, user and network. */
package org.u2sa.core.communication.limit;
