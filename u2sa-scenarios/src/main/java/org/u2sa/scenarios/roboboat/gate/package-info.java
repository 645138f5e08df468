/** Gates of two buoys and the way through them. */
package org.u2sa.scenarios.roboboat.gate;
