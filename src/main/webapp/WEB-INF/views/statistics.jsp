<%@ page contentType="text/html;charset=UTF-8" session="false" %>
<%@ taglib prefix="c" uri="jakarta.tags.core" %>
<%@ taglib prefix="fmt" uri="jakarta.tags.fmt" %>
<%@ taglib prefix="fn" uri="jakarta.tags.functions" %>
<%@ taglib prefix="t" tagdir="/WEB-INF/tags" %>
<c:set var="root" value="${pageContext.request.contextPath}"/>
<fmt:message key="statistics.title" var="title"/>
<t:page title="${title}" here="statistics" script="statistics/statistics.js">
  <div class="heading">
    <div>
      <h1>${title}</h1>
      <c:if test="${not empty period}"><p class="faint"><fmt:message key="statistics.period"><fmt:param value="${firstDay}"/><fmt:param value="${lastDay}"/><fmt:param value="${period.zone()}"/></fmt:message>${" "}<t:help topic="statistics" section="what-each-figure-is"/></p></c:if>
    </div>
  </div>
  <fmt:message key="statistics.choose" var="choose"/>
  <nav class="periods" aria-label="${choose}">
    <c:forEach items="${names}" var="name">
      <c:url value="/statistics" var="target"><c:param name="period" value="${name}"/><c:if test="${not empty param.zone and empty errors.zone}"><c:param name="zone" value="${param.zone}"/></c:if><c:if test="${not empty param.floor and empty errors.floor}"><c:param name="floor" value="${param.floor}"/></c:if></c:url>
      <a href="<c:out value="${target}"/>" ${name == chosen ? 'aria-current="page"' : ''}><fmt:message key="statistics.period.${name}"/></a>
    </c:forEach>
  </nav>
  <form method="get" action="${root}/statistics" class="filter">
    <c:forTokens items="from,to" delims="," var="name">
      <label><fmt:message key="statistics.${name}"/>
        <input name="${name}" type="date" value="${fn:escapeXml(param[name])}" required ${empty errors[name] ? '' : 'aria-invalid="true" aria-describedby="error-'.concat(name).concat('"')}>
      </label>
    </c:forTokens>
    <t:floor-choice/>
    <input type="hidden" id="zone" name="zone" value="${empty param.zone or not empty errors.zone ? 'UTC' : fn:escapeXml(param.zone)}">
    <button><fmt:message key="statistics.show"/></button>
  </form>
  <c:forTokens items="period,from,to,zone" delims="," var="name"><c:if test="${not empty errors[name]}"><p id="error-${name}" class="notice bad" role="alert"><c:out value="${errors[name]}"/></p></c:if></c:forTokens>
  <c:if test="${not empty period}">
    <c:forEach items="${floorViews}" var="floor"><c:if test="${not empty floor.chargerShortage}"><p class="notice bad"><t:said sentence="${floor.chargerShortage.text}"/></p></c:if></c:forEach>
    <div class="figures">
      <c:forTokens items="ordered,done,failed,cancelled" delims="," var="name"><article><p class="faint"><fmt:message key="statistics.column.${name}"/></p><p class="figure"><fmt:formatNumber value="${total[name]}"/></p></article></c:forTokens>
      <c:forTokens items="delivery,waiting,completion,orderError,startError" delims="," var="name">
        <fmt:message key="statistics.chart.${name}" var="what"/>
        <article>
          <p class="faint"><fmt:message key="statistics.median"><fmt:param value="${what}"/></fmt:message></p>
          <p class="figure"><t:amount value="${total[name].median()}" unit="SECONDS"/></p>
          <c:if test="${not empty total[name]}"><p class="faint"><fmt:message key="statistics.p90"/>${" "}<t:amount value="${total[name].p90()}" unit="SECONDS"/></p></c:if>
        </article>
      </c:forTokens>
      <article><p class="faint"><fmt:message key="statistics.chart.distance"/></p><p class="figure"><t:amount value="${total.metres()}" unit="METRES"/></p></article>
      <article><p class="faint"><fmt:message key="statistics.chart.battery"/></p><p class="figure"><t:amount value="${total.battery()}" unit="SHARE"/></p></article>
      <article><p class="faint"><fmt:message key="statistics.chart.failures"/></p><p class="figure"><fmt:formatNumber value="${total.failureCount()}"/></p></article>
    </div>
    <div class="charts">
      <c:forEach items="${series}" var="chart">
        <t:chart chart="${chart}"/>
      </c:forEach>
      <article>
        <c:forTokens items="causes,planned" delims="," var="list">
          <h2><fmt:message key="statistics.${list}"/></h2>
          <p class="faint"><fmt:message key="statistics.interruptions.${list}"/></p>
          <ul id="${list}">
            <c:forEach items="${total.failures()}" var="failure">
              <c:if test="${failure.key.isPlanned() == (list == 'planned')}">
                <c:url value="/history" var="history"><c:param name="kind" value="${failure.key.kind()}"/><c:param name="from" value="${period.begin()}"/><c:param name="until" value="${period.end()}"/></c:url>
                <li><a href="<c:out value="${history}"/>"><fmt:message key="statistics.column.${failure.key}"/></a>: <fmt:formatNumber value="${failure.value}"/></li>
              </c:if>
            </c:forEach>
          </ul>
        </c:forTokens>
      </article>
      <t:chart chart="${utilisation}"/>
    </div>
    <article class="card">
      <h2><fmt:message key="statistics.csv"/></h2>
      <p class="faint"><fmt:message key="statistics.csv.description"/></p>
      <div class="choices">
        <c:forTokens items="series,robots" delims="," var="file">
          <c:url value="/api/v1/statistics/${file}.csv" var="target"><c:param name="from" value="${period.from()}"/><c:param name="to" value="${period.to()}"/><c:param name="zone" value="${period.zone()}"/></c:url>
          <a href="<c:out value="${target}"/>" role="button" class="outline" download><fmt:message key="statistics.csv.${file}"/></a>
        </c:forTokens>
      </div>
    </article>
  </c:if>
</t:page>
