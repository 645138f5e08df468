/** Messages of arming, stopping and failsafes. */
package org.u2sa.messages.safety;
