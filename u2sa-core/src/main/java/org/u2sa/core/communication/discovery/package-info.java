/** How clients find the Communication Manager (mDNS). */
package org.u2sa.core.communication.discovery;
