<%@ page contentType="text/html;charset=UTF-8" session="false" %>
<%@ taglib prefix="c" uri="jakarta.tags.core" %>
<%@ taglib prefix="fmt" uri="jakarta.tags.fmt" %>
<%@ taglib prefix="fn" uri="jakarta.tags.functions" %>
<%@ taglib prefix="t" tagdir="/WEB-INF/tags" %>
<c:set var="root" value="${pageContext.request.contextPath}"/>
<fmt:message key="network.title" var="title"/>
<t:page title="${title}" here="network" script="shared/live.js">
  <div class="heading">
    <div>
      <h1>${title}</h1>
      <p class="faint"><c:choose><c:when test="${empty subnet}"><fmt:message key="network.dhcp.none"/></c:when><c:otherwise><fmt:message key="network.dhcp"><fmt:param value="${subnet}"/></fmt:message></c:otherwise></c:choose>${" "}<t:help topic="network"/></p>
    </div>
  </div>
  <c:if test="${param.done == 'added' or param.done == 'changed' or param.done == 'removed'}"><p class="notice good" role="status"><fmt:message key="network.done.${param.done}"/></p></c:if>
  <div id="live" data-live="network">
    <c:if test="${not empty trouble}"><p class="notice bad"><fmt:message key="network.trouble.${trouble.kind()}"><fmt:param value="${trouble.what()}"/></fmt:message></p></c:if>
    <c:if test="${empty entries}"><p class="notice"><fmt:message key="network.empty"/></p></c:if>
    <c:if test="${not empty entries}">
      <table class="stacks">
        <thead>
          <tr><c:forTokens items="name,kind,address,hardware,lease,reachable,actions" delims="," var="column"><c:if test="${column != 'actions' or caller.mayManage()}"><th scope="col"><fmt:message key="network.column.${column}"/></th></c:if></c:forTokens></tr>
        </thead>
        <tbody>
          <c:forEach items="${entries}" var="entry">
            <tr>
              <th scope="row"><c:choose>
                <c:when test="${entry.isRobot()}"><c:url value="/robots/${entry.name()}" var="link"/><a href="<c:out value="${link}"/>"><bdi><c:out value="${entry.name()}"/></bdi></a></c:when>
                <c:when test="${empty entry.name()}"><span class="faint"><fmt:message key="network.unnamed"/></span></c:when>
                <c:otherwise><bdi><c:out value="${entry.name()}"/></bdi></c:otherwise>
              </c:choose></th>
              <td><fmt:message key="network.kind.${entry.isUnknown() ? 'unknown' : entry.kind().word()}"/></td>
              <td data-label="<fmt:message key="network.column.address"/>"><span><c:choose><c:when test="${empty entry.address()}"><span class="faint"><fmt:message key="common.none"/></span></c:when><c:otherwise><bdi dir="ltr"><c:out value="${entry.address()}"/></bdi></c:otherwise></c:choose>
                <c:if test="${not empty subnet and not empty entry.device() and entry.device().isReservable()}"> <small class="faint"><fmt:message key="network.reserved"/></small></c:if>
                <c:if test="${not empty entry.otherAddress()}"><br><small><fmt:message key="network.otherAddress"><fmt:param value="${entry.otherAddress()}"/></fmt:message></small></c:if>
                <c:if test="${not empty entry.reservedElsewhere()}"><br><small><fmt:message key="network.reservedElsewhere"><fmt:param value="${entry.reservedElsewhere()}"/></fmt:message></small></c:if></span></td>
              <td data-label="<fmt:message key="network.column.hardware"/>"><c:choose><c:when test="${empty entry.hardware()}"><span class="faint"><fmt:message key="common.none"/></span></c:when><c:otherwise><bdi dir="ltr"><c:out value="${entry.hardware()}"/></bdi></c:otherwise></c:choose></td>
              <td data-label="<fmt:message key="network.column.lease"/>"><c:choose>
                <c:when test="${empty entry.lease()}"><span class="faint"><fmt:message key="common.none"/></span></c:when>
                <c:when test="${empty entry.lease().until()}"><fmt:message key="network.lease.endless"/></c:when>
                <c:otherwise><fmt:message key="network.lease.until"/>${" "}<t:time at="${entry.lease().until()}"/></c:otherwise>
              </c:choose></td>
              <td data-label="<fmt:message key="network.column.reachable"/>"><c:choose>
                <c:when test="${entry.reachable() == null}"><span class="faint"><fmt:message key="network.reachable.unknown"/></span></c:when>
                <c:when test="${entry.reachable()}"><span class="state" data-state="REACHABLE"><fmt:message key="network.reachable.yes"/></span></c:when>
                <c:otherwise><span class="state" data-state="UNREACHABLE"><fmt:message key="network.reachable.no"/></span><c:if test="${not empty entry.heardAt()}"><br><small class="faint"><fmt:message key="network.heardAt"/>${" "}<t:time at="${entry.heardAt()}"/></small></c:if></c:otherwise>
              </c:choose></td>
              <c:if test="${caller.mayManage()}">
                <td class="whole"><div class="choices"><c:choose>
                  <c:when test="${not empty entry.device()}"><a href="${root}/network?edit=${entry.device().id()}#device"><fmt:message key="network.change"/></a></c:when>
                  <c:otherwise>
                    <c:url value="/network" var="kept">
                      <c:param name="name" value="${entry.name()}"/>
                      <c:param name="kind" value="${entry.isRobot() ? 'robot' : ''}"/>
                      <c:param name="address" value="${entry.address()}"/>
                      <c:param name="hardwareAddress" value="${entry.hardware()}"/>
                    </c:url>
                    <c:if test="${entry.isUnknown() or not empty entry.hardware()}"><a href="<c:out value="${kept}"/>#device"><fmt:message key="${entry.isUnknown() or empty subnet ? 'network.name' : 'network.reserve'}"/></a></c:if>
                    <c:if test="${entry.isUnknown()}">
                      <c:url value="/robots" var="robot"><c:param name="name" value="${entry.name()}"/><c:param name="host" value="${entry.address()}"/></c:url>
                      <a href="<c:out value="${robot}"/>#add"><fmt:message key="network.addRobot"/></a>
                    </c:if>
                  </c:otherwise>
                </c:choose></div></td>
              </c:if>
            </tr>
          </c:forEach>
        </tbody>
      </table>
    </c:if>
  </div>
  <c:if test="${caller.mayManage()}">
    <article class="card" id="device">
      <h2><fmt:message key="${empty edited ? 'network.add' : 'network.edit'}"><fmt:param><bdi><c:out value="${edited.name()}"/></bdi></fmt:param></fmt:message></h2>
      <t:errors/>
      <form method="post" action="${root}/network${empty edited ? '' : '/'}${edited.id()}${empty edited ? '' : '/change'}" novalidate>
        <t:csrf/>
        <div class="grid">
          <div><t:field name="name" label="network.column.name" hint="network.name.hint" latin="true" value="${edited.name()}"/></div>
          <div>
            <c:set var="chosen" value="${param.kind == null ? edited.kind().word() : param.kind}"/>
            <label for="kind"><fmt:message key="network.column.kind"/></label>
            <select id="kind" name="kind" ${empty errors.kind ? '' : 'aria-invalid="true" aria-describedby="kind-help"'}>
              <c:forEach items="${kinds}" var="kind"><option value="${kind.word()}" ${kind.word() == chosen ? 'selected' : ''}><fmt:message key="network.kind.${kind.word()}"/></option></c:forEach>
            </select>
            <c:if test="${not empty errors.kind}"><small id="kind-help" class="wrong"><bdi><c:out value="${errors.kind}"/></bdi></small></c:if>
          </div>
        </div>
        <div class="grid">
          <div><t:field name="hardwareAddress" label="network.column.hardware" hint="network.hardware.hint" latin="true" optional="true" value="${edited.hardware()}"/></div>
          <div><t:field name="address" label="network.column.address" hint="${empty subnet ? 'network.address.hint' : 'network.address.hint.reserved'}" latin="true" optional="true" value="${edited.address()}"/></div>
        </div>
        <button><fmt:message key="${empty edited ? 'network.add' : 'notices.save'}"/></button>
        <c:if test="${not empty edited}"><a href="${root}/network"><fmt:message key="network.edit.leave"/></a></c:if>
      </form>
      <c:if test="${not empty edited}">
        <details class="or">
          <summary role="button" class="outline secondary"><fmt:message key="network.remove"/></summary>
          <form method="post" action="${root}/network/${edited.id()}/delete">
            <t:csrf/>
            <p><fmt:message key="network.remove.sure"/></p>
            <button class="danger"><fmt:message key="network.remove"/></button>
          </form>
        </details>
      </c:if>
    </article>
  </c:if>
</t:page>
