/** What the objects that were seen amount to. */
package org.u2sa.scenarios.vrx.sight;
