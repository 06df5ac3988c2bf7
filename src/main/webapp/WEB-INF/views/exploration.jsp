<%@ page contentType="text/html;charset=UTF-8" session="false" %>
<%@ taglib prefix="c" uri="jakarta.tags.core" %>
<%@ taglib prefix="fmt" uri="jakarta.tags.fmt" %>
<%@ taglib prefix="fn" uri="jakarta.tags.functions" %>
<%@ taglib prefix="t" tagdir="/WEB-INF/tags" %>
<c:set var="root" value="${pageContext.request.contextPath}"/>
<c:set var="here" value="${root}/floors/${segment}/exploration"/>
<c:set var="isRunning" value="${not empty exploration and not exploration.state().isOver()}"/>
<fmt:message key="exploration.title" var="title"><fmt:param value="${floor}"/></fmt:message>
<t:page title="${title}" here="floor" script="exploration/exploration.js">
  <div class="heading">
    <div>
      <h1><bdi><c:out value="${title}"/></bdi></h1>
      <p class="faint"><fmt:message key="exploration.intro"/>${" "}<t:help topic="maps" section="exploration"/></p>
    </div>
    <div class="choices"><a href="<c:out value="${root}/floors/${segment}/edit"/>"><fmt:message key="floors.edit"/></a><a href="${root}/floors"><fmt:message key="floors.title"/></a></div>
  </div>
  <t:texts keys="exploration.metres exploration.squareMetres laboratory.seconds"/>
  <t:errors/>
  <c:if test="${not empty exploration}">
    <section id="exploration" data-floor="<c:out value="${segment}"/>" data-exploration-state="${exploration.state()}">
      <div class="heading">
        <p><span class="state" data-state="${exploration.state()}"><fmt:message key="exploration.state.${exploration.state()}"/></span>
          <c:if test="${isRunning}"><fmt:message key="laboratory.progress" var="progress"/><progress max="1" value="${exploration.picture().share()}" aria-label="${progress}"></progress></c:if></p>
        <c:if test="${isRunning and not caller.isVisitor()}"><form method="post" action="<c:out value="${here}"/>/stop"><t:csrf/><button class="outline"><fmt:message key="laboratory.stop"/></button></form></c:if>
      </div>
      <c:if test="${isRunning}"><p class="notice"><fmt:message key="exploration.goesOn"/></p></c:if>
      <c:if test="${exploration.state() == 'NO_WAY' or exploration.state() == 'LOST' or exploration.state() == 'OUT_OF_TIME' or exploration.state() == 'FAILED' or exploration.state() == 'INTERRUPTED'}"><p class="notice bad"><fmt:message key="exploration.why.${exploration.state()}"/></p></c:if>
      <c:if test="${exploration.draft() == 'SAVED'}"><p class="notice good" role="status"><fmt:message key="exploration.saved"/>${" "}<a href="<c:out value="${root}/floors/${segment}/edit"/>"><fmt:message key="exploration.toEditor"/></a></p></c:if>
      <c:if test="${exploration.draft() == 'NOT_SAVED'}">
        <div class="notice bad">
          <p><fmt:message key="exploration.notSaved"/></p>
          <c:if test="${not caller.isVisitor()}"><form method="post" action="<c:out value="${here}"/>/draw"><t:csrf/><button class="outline"><fmt:message key="exploration.draw"/></button></form></c:if>
        </div>
      </c:if>
      <fmt:message key="exploration.canvas" var="canvas"/>
      <canvas class="exploration" tabindex="0" role="img" aria-label="${canvas}"></canvas>
      <ul class="legend exploration-legend">
        <c:forTokens items="free,wall,unknown,robot,lidar,way,target" delims="," var="mark"><li data-mark="${mark}"><fmt:message key="exploration.mark.${mark}"/></li></c:forTokens>
      </ul>
      <dl class="facts">
        <div><dt><fmt:message key="exploration.ground"/></dt><dd><bdi><c:choose><c:when test="${fn:startsWith(exploration.ground(), 'scene:')}"><fmt:message key="exploration.scene.${fn:substringAfter(exploration.ground(), ':')}"/></c:when><c:otherwise><c:out value="${fn:substringAfter(exploration.ground(), ':')}"/></c:otherwise></c:choose></bdi></dd></div>
        <div><dt><fmt:message key="exploration.robots"/></dt><dd><bdi>${exploration.order().robots()}</bdi></dd></div>
        <div><dt><fmt:message key="exploration.time"/></dt><dd data-fact="seconds"></dd></div>
        <div><dt><fmt:message key="exploration.driven"/></dt><dd data-fact="driven"></dd></div>
        <div><dt><fmt:message key="exploration.area"/></dt><dd data-fact="area"></dd></div>
        <div><dt><fmt:message key="laboratory.column.user"/></dt><dd><bdi><c:out value="${exploration.user()}"/></bdi></dd></div>
        <div><dt><fmt:message key="laboratory.started"/></dt><dd><t:time at="${exploration.startedAt()}"/></dd></div>
        <c:if test="${not empty exploration.endedAt()}"><div><dt><fmt:message key="laboratory.ended"/></dt><dd><t:time at="${exploration.endedAt()}"/></dd></div></c:if>
      </dl>
    </section>
  </c:if>
  <c:if test="${not isRunning and not caller.isVisitor()}">
    <article class="card">
      <h2><fmt:message key="exploration.start"/></h2>
      <p class="faint"><fmt:message key="exploration.start.intro"/></p>
      <form method="post" action="<c:out value="${here}"/>" novalidate>
        <t:csrf/>
        <label for="ground"><fmt:message key="exploration.ground"/></label>
        <select id="ground" name="ground" aria-describedby="ground-help" ${empty errors.ground ? '' : 'aria-invalid="true"'}>
          <c:forEach items="${grounds}" var="ground">
            <fmt:formatNumber value="${ground.width()}" maxFractionDigits="1" var="width"/>
            <fmt:formatNumber value="${ground.height()}" maxFractionDigits="1" var="height"/>
            <option value="<c:out value="${ground.value()}"/>" ${(empty param.ground ? exploration.ground() : param.ground) == ground.value() ? 'selected' : ''}><c:choose><c:when test="${not empty ground.scene()}"><fmt:message key="exploration.scene.${ground.scene()}"/></c:when><c:otherwise><fmt:message key="exploration.floorMap"><fmt:param><c:out value="${ground.name()}"/></fmt:param></fmt:message></c:otherwise></c:choose>, <fmt:message key="loads.size"><fmt:param value="${width}"/><fmt:param value="${height}"/></fmt:message></option>
          </c:forEach>
        </select>
        <small id="ground-help"><c:choose><c:when test="${not empty errors.ground}"><bdi><c:out value="${errors.ground}"/></bdi></c:when><c:otherwise><fmt:message key="exploration.ground.hint"/></c:otherwise></c:choose></small>
        <div class="grid">
          <div><t:field name="robots" label="exploration.robots" hint="exploration.robots.hint" inputmode="numeric" value="${proposed.robots()}"/></div>
          <div><t:field name="seed" label="laboratory.seed" hint="exploration.seed.hint" inputmode="numeric" value="${proposed.seed()}"/></div>
        </div>
        <div class="grid">
          <div><t:field name="startX" label="exploration.startX" inputmode="decimal" value="${proposed.start().x()}"/></div>
          <div><t:field name="startY" label="exploration.startY" inputmode="decimal" value="${proposed.start().y()}"/></div>
          <div><t:field name="targetX" label="exploration.targetX" inputmode="decimal" value="${proposed.target().x()}"/></div>
          <div><t:field name="targetY" label="exploration.targetY" inputmode="decimal" value="${proposed.target().y()}"/></div>
        </div>
        <button><fmt:message key="exploration.start.submit"/></button>
      </form>
    </article>
  </c:if>
</t:page>
