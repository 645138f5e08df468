/** Discovery of the Communication Manager by mDNS. */
package org.u2sa.core.communication.discovery;
