/** Range finders and lidars. The use of distances and scans belongs to {@code org.u2sa.device}. */
package org.u2sa.drivers.range;
